/** What `Download` gives. Files are made in a worker (files/), which is loaded when the first is asked for. */
import { exportFile } from "../../files/exporter";
import type { Specimen } from "../../specimen/specimen";
import type { Shown, StudioState } from "../studio_state";

export interface Download {
	readonly key: string;
	readonly title: string;
	readonly about: string;
	/** After the plant's name. */
	readonly suffix: string;
	/**
	 * @param link the whole address that brings it back
	 * @param name without extension
	 * @param signal cancels; the promise then rejects with its reason
	 */
	make(plant: Shown, link: string, name: string, signal?: AbortSignal): Promise<Blob>;
}

type Listed = Omit<Download, "make">;

const GLB: Listed = {
	key: "glb",
	title: "GLB",
	about: "glTF, one node per part; opens everywhere",
	suffix: ".glb",
};

/** Of plants whose parts share meshes. */
const GLB_INSTANCED: Listed = {
	key: "glb-instanced",
	title: "GLB, instanced",
	about: "Equal parts in one node; for readers of EXT_mesh_gpu_instancing",
	suffix: "-instanced.glb",
};

const OF_EVERY_PLANT: readonly Listed[] = [
	{ key: "obj", title: "OBJ with MTL", about: "Both in one .zip", suffix: "-obj.zip" },
	{ key: "json", title: "JSON", about: "Every part as numbers, in metres", suffix: ".json" },
];

/**
 * What there is of a plant.
 * @param picture takes one of the 3-D view, where there is a view
 * @param write makes all the others
 */
export function formatsOf(shown: Shown, picture: StudioState["picture"], write = exportFile): readonly Download[] {
	const { model, grown } = shown;
	const own = (model.formats ?? []).filter(({ applies }) => applies?.(grown) ?? true);
	const listed: Listed[] = [GLB, ...(hasInstances(shown) ? [GLB_INSTANCED] : []), ...OF_EVERY_PLANT, ...own];
	const written = listed.map(({ key, title, about, suffix }): Download => {
		const make: Download["make"] = ({ model, grown, from }, link, name, signal) => {
			const request = { model: model.name, format: key, grown, specimen: from, link, name };
			return write(model, request, signal ? { signal } : {});
		};
		return { key, title, about, suffix, make };
	});
	return [...written, ...(picture ? [pictureBy(picture)] : [])];
}

function pictureBy(take: () => Promise<Blob>): Download {
	return { key: "png", title: "Picture", about: "The 3-D view as a PNG", suffix: ".png", make: take };
}

/** Whether some parts are one mesh many times, so that instances make the file another one. */
function hasInstances({ model, grown }: Shown): boolean {
	return model.instanced?.(grown) ?? grown.organs.mesh.some((mesh) => mesh >= 0);
}

/** "long-conical-7", or "long-conical-altered-7": what a file of this plant is called. */
export function fileName({ preset, seed }: Specimen, altered = false): string {
	return altered ? `${preset}-altered-${seed}` : `${preset}-${seed}`;
}

/** Hands a file to the browser's downloads. */
export function save(blob: Blob, name: string): void {
	const anchor = document.createElement("a");
	anchor.href = URL.createObjectURL(blob);
	anchor.download = name;
	anchor.click();
	// The download has taken its own hold of the data by then.
	setTimeout(() => URL.revokeObjectURL(anchor.href), 60_000);
}
