/** What `Download` gives. Files are made in a worker (files/), which is loaded when the first is asked for. */

import { coreAddress } from "../../core/core_address";
import { type FileOptions, PLANT_FILES } from "../../formats/plant_files";
import { withLink } from "../../formats/png_link";
import { hasAges } from "../../generate/files/aged";
import { exportFile } from "../../generate/files/exporter";
import type { Specimen } from "../../specimen/specimen";
import type { PictureOptions, Shown, StudioState } from "../studio_state";

export interface Download {
	readonly key: string;
	readonly title: string;
	readonly about: string;
	/** After the plant's name. */
	readonly suffix: string;
	/** Whether its size is told, which takes making it. */
	readonly sized: boolean;
	/** Whether that takes seconds. */
	readonly slow?: boolean;
	make(asked: Asked, signal?: AbortSignal): Promise<Blob>;
}

/** What is to be made into a file. */
export interface Asked {
	readonly plant: Shown;
	/** The whole address that brings it back. */
	readonly link: string;
	/** Without extension. */
	readonly name: string;
	readonly options: FileOptions & Pick<PictureOptions, "height">;
}

type Listed = Pick<Download, "key" | "title" | "about" | "suffix" | "slow">;

const OF_EVERY_PLANT: readonly Listed[] = [
	{ key: "obj", title: "OBJ with MTL", about: "Both in one .zip", suffix: "-obj.zip" },
	{ key: "json", title: "JSON", about: "Every part as numbers, in metres", suffix: ".json" },
];

/**
 * What there is of a plant.
 * @param picture takes one of the 3-D view, where there is a view
 * @param write makes all the others; cancelled by its signal, it rejects with the signal's reason
 */
export function formatsOf(shown: Shown, picture: StudioState["picture"], write = exportFile): readonly Download[] {
	const { model, grown } = shown;
	const own = (model.formats ?? []).filter(({ applies }) => applies?.(grown) ?? true);
	// What grows the plant again, otherwise.
	const core = coreAddress(model.wasm);
	const ages = core !== undefined && hasAges(model, shown.from);
	const levels = core !== undefined && model.levels !== undefined;
	const meshes = PLANT_FILES.filter(
		({ shared, life, blown, levelled }) =>
			(!shared || hasInstances(shown)) && (!life || ages) && !(blown && model.still) && (!levelled || levels),
	);
	const listed: Listed[] = [...meshes, ...OF_EVERY_PLANT, ...own];
	const written = listed.map(({ key, title, about, suffix, slow = false }): Download => {
		const make: Download["make"] = ({ plant: { model, grown, from }, ...asked }, signal) => {
			const again = core === undefined ? {} : { core };
			const request = { model: model.name, format: key, grown, specimen: from, ...again, ...asked };
			return write(model, request, signal ? { signal } : {});
		};
		return { key, title, about, suffix, slow, sized: true, make };
	});
	return [...written, ...(picture ? picturesBy(picture) : [])];
}

function picturesBy(take: NonNullable<StudioState["picture"]>): Download[] {
	const sizeOf = ({ options: { height } }: Asked) => (height === undefined ? {} : { height });
	return [
		{
			key: "png",
			title: "Picture",
			about: "The 3-D view as a PNG",
			suffix: ".png",
			sized: false,
			make: async (asked) => withLink(await take(sizeOf(asked)), asked.link),
		},
		{
			key: "png-alone",
			title: "Picture, cut out",
			about: "The same with nothing behind the plant: a transparent PNG",
			suffix: "-cut-out.png",
			sized: false,
			make: async (asked) => withLink(await take({ ...sizeOf(asked), alone: true }), asked.link),
		},
	];
}

/** Whether some parts are one mesh many times, so that instances make the file another one. */
function hasInstances({ model, grown }: Shown): boolean {
	return model.instanced?.(grown) ?? grown.organs.mesh.some((mesh) => mesh >= 0);
}

/** "long-conical-7", or "long-conical-altered-7": what a file of this plant is called. */
export function fileName({ preset, seed }: Specimen, altered = false): string {
	return altered ? `${preset}-altered-${seed}` : `${preset}-${seed}`;
}
