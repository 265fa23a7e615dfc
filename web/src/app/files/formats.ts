/** Lists the formats of the download sheet. Files are made in a worker, which is loaded for the first file. */

import { coreAddress } from "../../core/core_address";
import type { FileOptions } from "../../formats/file_options";
import { hasCrown } from "../../formats/game/has_crown";
import { PLANT_FILES } from "../../formats/plant_files";
import { withLink } from "../../formats/png_link";
import { hasAges } from "../../generate/files/aged";
import { exportFile } from "../../generate/files/exporter";
import type { Specimen } from "../../specimen/specimen";
import { text } from "../messages.generated";
import type { PictureOptions, ShownPlant, StudioState } from "../studio_state";

export interface DownloadFormat {
	readonly key: string;
	readonly title: string;
	readonly about: string;
	/** The end of the file's name, after the plant's name. */
	readonly suffix: string;
	/** Whether the sheet shows its size, which requires making the file. */
	readonly sized: boolean;
	/** Whether making it takes seconds. */
	readonly slow?: boolean;
	/** The options that it uses. */
	readonly uses?: readonly (keyof DownloadOptions)[];
	make(request: DownloadRequest, signal?: AbortSignal): Promise<Blob>;
}

/** Options of a file; a file ignores those that it does not use. */
export type DownloadOptions = FileOptions & Pick<PictureOptions, "height">;

/** A plant to be made into a file. */
export interface DownloadRequest {
	readonly plant: ShownPlant;
	/** The absolute link to the plant. */
	readonly link: string;
	/** Without extension. */
	readonly name: string;
	readonly options: DownloadOptions;
}

type FormatEntry = Pick<DownloadFormat, "key" | "title" | "about" | "suffix" | "slow" | "uses">;

/** Returns the formats of all models, in the language in use. */
const formatsOfEveryPlant = (): FormatEntry[] => [
	{ key: "obj", title: text("download_obj"), about: text("download_obj_about"), suffix: "-obj.zip" },
	{ key: "json", title: text("download_json"), about: text("download_json_about"), suffix: ".json" },
];

/**
 * Returns the formats available for a plant.
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
		({ shared, life, blown, levelled, crowned }) =>
			(!shared || hasInstances(shown)) &&
			(!life || ages) &&
			!(blown && model.still) &&
			(!levelled || levels) &&
			(!crowned || hasCrown(grown)),
	);
	const titled = meshes.map((file) => ({ ...file, title: file.title(), about: file.about() }));
	const listed: FormatEntry[] = [...titled, ...formatsOfEveryPlant(), ...own];
	const written = listed.map(({ key, title, about, suffix, slow = false, uses = [] }): DownloadFormat => {
		const make: DownloadFormat["make"] = ({ plant: { model, grown, from }, ...rest }, signal) => {
			const again = core === undefined ? {} : { core };
			const request = { model: model.name, format: key, grown, specimen: from, ...again, ...rest };
			return write(model, request, signal ? { signal } : {});
		};
		return { key, title, about, suffix, slow, uses, sized: true, make };
	});
	return [...written, ...(picture ? picturesBy(picture) : [])];
}

/**
 * Returns the formats that are pictures of the view: with its background, and cut out with transparency.
 * @param take draws the picture, `height` pixels high or as high as the view
 */
function picturesBy(take: NonNullable<StudioState["picture"]>): DownloadFormat[] {
	const sizeOf = ({ options: { height } }: DownloadRequest) => (height === undefined ? {} : { height });
	return [
		{
			key: "png",
			title: text("download_picture"),
			about: text("download_picture_about"),
			suffix: ".png",
			sized: false,
			uses: ["height"],
			make: async (request) => withLink(await take(sizeOf(request)), request.link),
		},
		{
			key: "png-alone",
			title: text("download_cutout"),
			about: text("download_cutout_about"),
			suffix: "-cut-out.png",
			sized: false,
			uses: ["height"],
			make: async (request) => withLink(await take({ ...sizeOf(request), alone: true }), request.link),
		},
	];
}

/** Returns whether some parts share a mesh, so that a file with instances differs. */
function hasInstances({ model, grown }: ShownPlant): boolean {
	return model.instanced?.(grown) ?? grown.organs.mesh.some((mesh) => mesh >= 0);
}

/** Returns the name of a plant's files, without ending: "long-conical-7", or "long-conical-altered-7". */
export function fileName({ preset, seed }: Specimen, altered = false): string {
	return altered ? `${preset}-altered-${seed}` : `${preset}-${seed}`;
}
