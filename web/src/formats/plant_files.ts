/** Files with meshes for every plant: their names, and their writers, loaded on demand. */
import type { Part } from "../plant/part";
import type { Sway } from "../plant/sway";
import type { Wooden } from "../plant/wood/wooden";
import type { About } from "./about";
import type { FileOptions } from "./file_options";
import type { Aged } from "./growth_glb";
import { checkMeshBytes, type WrittenInstances } from "./limits";
import type { Levels } from "./lod_glb";
import { text } from "./messages.generated";

/** Further data of a plant, for files that move or have levels of detail. */
export interface Further {
	/** The plant at other ages, for files with `life`; absent where it has none. */
	readonly aged?: Aged | undefined;
	/** Motion in wind; absent where wind does not move it. */
	readonly sway?: Sway | undefined;
	/** The plant at several levels of detail; absent for models without levels. */
	readonly levels?: Levels | undefined;
	/** The plant of the parts: files with few triangles attach its leaves to its wood. */
	readonly plant?: Wooden | undefined;
	/** Receives a sentence for each way in which the file differs from the request. */
	readonly note?: ((text: string) => void) | undefined;
}

export interface PlantFile {
	/** The name for programs: `glb-web`. */
	readonly key: string;
	/** The suffix of file names: `glb`. */
	readonly ending: string;
	/** The form among files with the same suffix; the first one is the default. */
	readonly form?: string;
	title(): string;
	/** One line of description. */
	about(): string;
	/** The end of the file's name, after the plant's name. */
	readonly suffix: string;
	/** The media type of the file. */
	readonly type: string;
	/** The options that it uses. */
	readonly uses?: readonly (keyof FileOptions)[];
	/** Whether it is useful only where parts share meshes. */
	readonly shared?: true;
	/** Whether making it takes seconds. */
	readonly slow?: true;
	/** Whether it shows the plant at many ages: only for plants that have ages. */
	readonly life?: true;
	/** Whether it shows motion in wind, if the plant has any. */
	readonly blown?: true;
	/** Whether it has levels of detail: only for models that make them. */
	readonly levelled?: true;
	/** Whether it is only for trees with leaves (game/has_crown.ts). */
	readonly crowned?: true;
	/** How it writes instances, for its limits (limits.ts); absent for files that simplify the parts. */
	readonly instances?: WrittenInstances;
	/**
	 * @param parts only read; the same parts and options give the same bytes
	 * @throws FileTooLargeError where the file would exceed the limits of files (limits.ts)
	 */
	make(parts: Iterable<Part>, about: About, options: FileOptions, further?: Further): Promise<Uint8Array<ArrayBuffer>>;
}

/** The default of the *wind* form. */
export const WIND_TRIANGLES = 40_000;
/** The default of the *low* form. */
export const LOW_TRIANGLES = 20_000;

/** The default for printers: a nozzle of 0.4 mm prints it safely. */
export const THICKNESS = 1;
/** The default of a cloud. */
export const POINTS = 100_000;

const GLB = { ending: "glb", type: "model/gltf-binary" } as const;

const FILES: readonly PlantFile[] = [
	{
		...GLB,
		key: "glb",
		form: "detailed",
		title: () => text("glb_title"),
		about: () => text("glb_about"),
		instances: "nodes",
		suffix: ".glb",
		uses: ["translucent", "textures"],
		make: async (parts, about, { translucent = false, textures = false }) => {
			const shown = textures ? await (await import("./baked")).baked([...parts]) : parts;
			return (await import("./glb")).exportGlb(shown, about, { translucent });
		},
	},
	{
		...GLB,
		key: "glb-web",
		form: "web",
		title: () => text("glb_web_title"),
		about: () => text("glb_web_about"),
		instances: "meshes",
		suffix: "-web.glb",
		make: async (parts, about) => (await import("./web_glb")).webGlb(parts, about),
	},
	{
		...GLB,
		key: "glb-low",
		form: "low",
		title: () => text("glb_low_title"),
		about: () => text("glb_low_about", { triangles: LOW_TRIANGLES }),
		instances: "meshes",
		suffix: "-low.glb",
		uses: ["triangles"],
		make: async (parts, about, { triangles }, { plant } = {}) =>
			(await import("./low_glb")).lowGlb(parts, about, triangles, plant),
	},
	{
		...GLB,
		key: "glb-instanced",
		form: "instanced",
		title: () => text("glb_instanced_title"),
		about: () => text("glb_instanced_about"),
		instances: "shared",
		suffix: "-instanced.glb",
		uses: ["translucent"],
		shared: true,
		make: async (parts, about, { translucent = false }) => {
			const shared = [...parts].map((await import("./alike")).alike);
			return (await import("./glb")).exportGlb(shared, about, { instancing: true, translucent });
		},
	},
	{
		...GLB,
		key: "glb-growth",
		form: "growth",
		title: () => text("glb_growth_title"),
		about: () => text("glb_growth_about"),
		suffix: "-growth.glb",
		life: true,
		slow: true,
		make: async (_, about, __, { aged } = {}) => {
			if (!aged) throw new Error(text("no_ages"));
			return (await import("./growth_glb")).growthGlb(aged, about);
		},
	},
	{
		...GLB,
		key: "glb-wind",
		form: "wind",
		title: () => text("glb_wind_title"),
		about: () => text("glb_wind_about"),
		instances: "meshes",
		suffix: "-wind.glb",
		uses: ["triangles"],
		blown: true,
		slow: true,
		make: async (parts, about, { triangles }, { sway, plant } = {}) =>
			(await import("./wind_glb")).windGlb(parts, about, sway, triangles, plant),
	},
	{
		...GLB,
		key: "glb-lod",
		form: "lod",
		title: () => text("glb_lod_title"),
		about: () => text("glb_lod_about"),
		suffix: "-lod.glb",
		levelled: true,
		make: async (_, about, __, { levels } = {}) => {
			if (!levels) throw new Error(text("no_levels"));
			return (await import("./lod_glb")).lodGlb(levels, about);
		},
	},
	{
		key: "zip-game",
		ending: "zip",
		form: "game",
		title: () => text("zip_game_title"),
		about: () => text("zip_game_about"),
		suffix: "-game.zip",
		type: "application/zip",
		uses: ["windColours"],
		crowned: true,
		slow: true,
		make: async (parts, about, { windColours = false }, { plant } = {}) =>
			(await import("./game/game_tree")).gameTree(parts, about, plant, windColours),
	},
	{
		key: "usdz",
		ending: "usdz",
		type: "model/vnd.usdz+zip",
		title: () => text("usdz_title"),
		about: () => text("usdz_about"),
		instances: "meshes",
		suffix: ".usdz",
		make: async (parts, about, _, { plant } = {}) => (await import("./usdz")).usdz(parts, about, plant),
	},
	{
		key: "ply",
		ending: "ply",
		type: "application/octet-stream",
		title: () => text("ply_title"),
		about: () => text("ply_about"),
		instances: "meshes",
		suffix: ".ply",
		uses: ["points"],
		make: async (parts, about, { points = POINTS }) => (await import("./ply")).ply(parts, about, points),
	},
	{
		key: "3mf",
		ending: "3mf",
		type: "model/3mf",
		title: () => text("three_mf_title"),
		about: () => text("three_mf_about"),
		instances: "meshes",
		suffix: ".3mf",
		uses: ["thickness"],
		slow: true,
		make: async (parts, about, { thickness = THICKNESS }, { note } = {}) =>
			(await import("./three_mf")).threeMf(parts, about, thickness, note),
	},
	{
		key: "stl",
		ending: "stl",
		type: "model/stl",
		title: () => text("stl_title"),
		about: () => text("stl_about"),
		instances: "meshes",
		suffix: ".stl",
		uses: ["thickness"],
		slow: true,
		make: async (parts, about, { thickness = THICKNESS }, { note } = {}) =>
			(await import("./stl")).stl(parts, about, thickness, note),
	},
];

/** Each checks its size against the limit before it is made. */
export const PLANT_FILES: readonly PlantFile[] = FILES.map((file) => {
	const { instances, make } = file;
	if (!instances) return file;
	const checked: PlantFile["make"] = async (parts, ...others) => {
		const all = [...parts];
		checkMeshBytes(all, instances);
		return make(all, ...others);
	};
	return { ...file, make: checked };
});

/** Returns the file for a suffix and perhaps a form; undefined if there is none. */
export function plantFile(ending: string, form?: string): PlantFile | undefined {
	return PLANT_FILES.find((file) => file.ending === ending && (form === undefined || file.form === form));
}

/** All forms, in the order of a sentence. */
export const FORMS = PLANT_FILES.flatMap(({ form }) => form ?? []);
