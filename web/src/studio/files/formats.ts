/** What `Download` gives. Exporters are loaded when first asked for: they are no part of the first load. */
import type { Grown, Procedure } from "../../models/bunch/grown";
import type { Specimen } from "../../specimen/specimen";
import { zip } from "./zip";

export interface Format {
	readonly key: string;
	readonly title: string;
	readonly about: string;
	/** After the bunch's name. */
	readonly suffix: string;
	/** The one procedure whose bunches it suits; absent where it suits all. */
	readonly procedure?: Procedure;
	make(bunch: Bunch): Promise<Blob>;
}

/** What the formats write from. */
export interface Bunch {
	grown: Grown;
	specimen: Specimen;
	/** The whole address that brings it back. */
	link: string;
	/** Without extension. */
	name: string;
	/** The 3-D view as a PNG, where there is a view. */
	picture(): Promise<Blob>;
}

export const FORMATS: readonly Format[] = [
	{
		key: "glb",
		title: "GLB",
		about: "glTF, one node per berry; opens everywhere",
		suffix: ".glb",
		make: (bunch) => glb(bunch, false),
	},
	{
		key: "glb-instanced",
		title: "GLB, instanced",
		about: "All berries in one node; for readers of EXT_mesh_gpu_instancing",
		suffix: "-instanced.glb",
		procedure: "paper",
		make: (bunch) => glb(bunch, true),
	},
	{ key: "obj", title: "OBJ with MTL", about: "Both in one .zip", suffix: "-obj.zip", make: obj },
	{ key: "json", title: "JSON", about: "Every berry and internode as numbers, in metres", suffix: ".json", make: json },
	{
		key: "csv",
		title: "Berries as CSV",
		about: "One line a berry: place, size, exposure, colour, ripeness",
		suffix: "-berries.csv",
		make: csv,
	},
	{ key: "png", title: "Picture", about: "The 3-D view as a PNG", suffix: ".png", make: (bunch) => bunch.picture() },
];

async function glb({ grown, specimen, link }: Bunch, instancing: boolean): Promise<Blob> {
	const [{ exportGlb }, { bunchParts }, { aboutBunch }] = await Promise.all([
		import("../../export/glb"),
		import("../../models/bunch/parts/bunch_parts"),
		import("../../models/bunch/parts/about"),
	]);
	const about = await aboutBunch(grown, specimen, link);
	return new Blob([exportGlb(bunchParts(grown, specimen), about, { instancing })], { type: "model/gltf-binary" });
}

async function obj({ grown, specimen, link, name }: Bunch): Promise<Blob> {
	const [{ exportObj }, { bunchParts }, { aboutBunch }] = await Promise.all([
		import("../../export/obj"),
		import("../../models/bunch/parts/bunch_parts"),
		import("../../models/bunch/parts/about"),
	]);
	const { obj, mtl } = exportObj(bunchParts(grown, specimen), await aboutBunch(grown, specimen, link), name);
	return zip([
		{ name: `${name}.obj`, bytes: new TextEncoder().encode(obj) },
		{ name: `${name}.mtl`, bytes: new TextEncoder().encode(mtl) },
	]);
}

async function json({ grown, specimen }: Bunch): Promise<Blob> {
	const { exportJson } = await import("../../export/json");
	return new Blob([`${JSON.stringify(exportJson(grown, specimen), null, "\t")}\n`], { type: "application/json" });
}

async function csv({ grown, specimen }: Bunch): Promise<Blob> {
	const { berriesCsv } = await import("../../models/bunch/tables");
	return new Blob([berriesCsv(grown, specimen)], { type: "text/csv" });
}

/** "long-conical-7": what a file of this bunch is called. */
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
