/** What `Download` gives. Exporters are loaded when first asked for: they are no part of the first load. */
import type { Specimen } from "../../specimen/specimen";
import type { Shown, StudioState } from "../studio_state";
import { zip } from "./zip";

export interface Download {
	readonly key: string;
	readonly title: string;
	readonly about: string;
	/** After the plant's name. */
	readonly suffix: string;
	/**
	 * @param link the whole address that brings it back
	 * @param name without extension
	 */
	make(plant: Shown, link: string, name: string): Promise<Blob>;
}

const GLB: Download = {
	key: "glb",
	title: "GLB",
	about: "glTF, one node per part; opens everywhere",
	suffix: ".glb",
	make: (plant, link) => glb(plant, link, false),
};

/** Of plants whose parts share meshes. */
const GLB_INSTANCED: Download = {
	key: "glb-instanced",
	title: "GLB, instanced",
	about: "Equal parts in one node; for readers of EXT_mesh_gpu_instancing",
	suffix: "-instanced.glb",
	make: (plant, link) => glb(plant, link, true),
};

const OF_EVERY_PLANT: readonly Download[] = [
	{ key: "obj", title: "OBJ with MTL", about: "Both in one .zip", suffix: "-obj.zip", make: obj },
	{ key: "json", title: "JSON", about: "Every part as numbers, in metres", suffix: ".json", make: json },
];

/**
 * What there is of a plant.
 * @param picture takes one of the 3-D view, where there is a view
 */
export function formatsOf(shown: Shown, picture: StudioState["picture"]): readonly Download[] {
	const { model, grown } = shown;
	const own = (model.formats ?? []).filter(({ applies }) => applies?.(grown) ?? true);
	return [
		GLB,
		...(hasInstances(shown) ? [GLB_INSTANCED] : []),
		...OF_EVERY_PLANT,
		...own.map(
			(format): Download => ({
				...format,
				make: async (plant, link) =>
					new Blob([await format.make(plant.grown, plant.from, link)], { type: format.type }),
			}),
		),
		...(picture ? [pictureBy(picture)] : []),
	];
}

function pictureBy(take: () => Promise<Blob>): Download {
	return { key: "png", title: "Picture", about: "The 3-D view as a PNG", suffix: ".png", make: take };
}

/** Whether some parts are one mesh many times, so that instances make the file another one. */
function hasInstances({ model, grown }: Shown): boolean {
	return model.instanced?.(grown) ?? grown.organs.mesh.some((mesh) => mesh >= 0);
}

async function glb({ model, grown, from }: Shown, link: string, instancing: boolean): Promise<Blob> {
	const [{ exportGlb }, { aboutPlant }] = await Promise.all([
		import("../../export/glb"),
		import("../../export/about_plant"),
	]);
	const about = await aboutPlant(model, grown, from, link);
	return new Blob([exportGlb(model.parts(grown, from), about, { instancing })], { type: "model/gltf-binary" });
}

async function obj({ model, grown, from }: Shown, link: string, name: string): Promise<Blob> {
	const [{ exportObj }, { aboutPlant }] = await Promise.all([
		import("../../export/obj"),
		import("../../export/about_plant"),
	]);
	const { obj, mtl } = exportObj(model.parts(grown, from), await aboutPlant(model, grown, from, link), name);
	return zip([
		{ name: `${name}.obj`, bytes: new TextEncoder().encode(obj) },
		{ name: `${name}.mtl`, bytes: new TextEncoder().encode(mtl) },
	]);
}

async function json({ model, grown, from }: Shown): Promise<Blob> {
	const { exportJson } = await import("../../export/json");
	return new Blob([`${JSON.stringify(exportJson(model, grown, from), null, "\t")}\n`], { type: "application/json" });
}

/** "long-conical-7": what a file of this plant is called. */
export function fileName({ preset, seed }: Specimen): string {
	return `${preset}-${seed}`;
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
