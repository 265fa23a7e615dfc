/** Lists the formats of the `Download` menu. Files are made in a worker, which is loaded for the first file. */

import { coreAddress } from "../../core/core_address";
import type { FileOptions } from "../../formats/file_options";
import { PLANT_FILES } from "../../formats/plant_files";
import { withLink } from "../../formats/png_link";
import { hasAges } from "../../generate/files/aged";
import { exportFile } from "../../generate/files/exporter";
import type { Specimen } from "../../specimen/specimen";
import type { PictureOptions, ShownPlant, StudioState } from "../studio_state";

export interface DownloadFormat {
	readonly key: string;
	readonly title: string;
	readonly about: string;
	/** The end of the file's name, after the plant's name. */
	readonly suffix: string;
	/** Whether the menu shows its size, which requires making the file. */
	readonly sized: boolean;
	/** Whether making it takes seconds. */
	readonly slow?: boolean;
	make(request: DownloadRequest, signal?: AbortSignal): Promise<Blob>;
}

/** A plant to be made into a file. */
export interface DownloadRequest {
	readonly plant: ShownPlant;
	/** The absolute link to the plant. */
	readonly link: string;
	/** Without extension. */
	readonly name: string;
	readonly options: FileOptions & Pick<PictureOptions, "height">;
}

type FormatEntry = Pick<DownloadFormat, "key" | "title" | "about" | "suffix" | "slow">;

const OF_EVERY_PLANT: readonly FormatEntry[] = [
	{ key: "obj", title: "OBJ with MTL", about: "Both in one .zip", suffix: "-obj.zip" },
	{ key: "json", title: "JSON", about: "Every part as numbers, in metres", suffix: ".json" },
];

/**
 * The formats available for a plant.
 * @param picture takes a picture of the 3-D view; undefined without a view
 * @param write makes all other files; rejects with the signal's reason when cancelled
 */
export function downloadFormats(
	shown: ShownPlant,
	picture: StudioState["picture"],
	write = exportFile,
): readonly DownloadFormat[] {
	const { model, grown } = shown;
	const own = (model.formats ?? []).filter(({ applies }) => applies?.(grown) ?? true);
	// These formats grow the plant again, at other ages or in other detail.
	const core = coreAddress(model.wasm);
	const ages = core !== undefined && hasAges(model, shown.from);
	const levels = core !== undefined && model.levels !== undefined;
	const meshes = PLANT_FILES.filter(
		({ shared, life, blown, levelled }) =>
			(!shared || hasInstances(shown)) && (!life || ages) && !(blown && model.still) && (!levelled || levels),
	);
	const listed: FormatEntry[] = [...meshes, ...OF_EVERY_PLANT, ...own];
	const written = listed.map(({ key, title, about, suffix, slow = false }): DownloadFormat => {
		const make: DownloadFormat["make"] = ({ plant: { model, grown, from }, ...rest }, signal) => {
			const again = core === undefined ? {} : { core };
			const request = { model: model.name, format: key, grown, specimen: from, ...again, ...rest };
			return write(model, request, signal ? { signal } : {});
		};
		return { key, title, about, suffix, slow, sized: true, make };
	});
	return [...written, ...(picture ? picturesBy(picture) : [])];
}

function picturesBy(take: NonNullable<StudioState["picture"]>): DownloadFormat[] {
	const sizeOf = ({ options: { height } }: DownloadRequest) => (height === undefined ? {} : { height });
	return [
		{
			key: "png",
			title: "Picture",
			about: "The 3-D view as a PNG",
			suffix: ".png",
			sized: false,
			make: async (request) => withLink(await take(sizeOf(request)), request.link),
		},
		{
			key: "png-alone",
			title: "Picture, cut out",
			about: "The same with nothing behind the plant: a transparent PNG",
			suffix: "-cut-out.png",
			sized: false,
			make: async (request) => withLink(await take({ ...sizeOf(request), alone: true }), request.link),
		},
	];
}

/** Whether some parts share a mesh, so that a file with instances differs. */
function hasInstances({ model, grown }: ShownPlant): boolean {
	return model.instanced?.(grown) ?? grown.organs.mesh.some((mesh) => mesh >= 0);
}

/** The name of a plant's files, without ending: "long-conical-7", or "long-conical-altered-7". */
export function fileName({ preset, seed }: Specimen, altered = false): string {
	return altered ? `${preset}-altered-${seed}` : `${preset}-${seed}`;
}
