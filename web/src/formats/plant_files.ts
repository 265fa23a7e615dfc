/** Files with meshes that there are of every plant: what they are called, and what makes them when one is asked for. */
import type { Part } from "../plant/part";
import type { Sway } from "../plant/sway";
import type { About } from "./about";
import type { Aged } from "./growth_glb";
import { checkMeshBytes, type WrittenInstances } from "./limits";
import type { Levels } from "./lod_glb";

/** What a person may say of a file; what a file does not heed changes nothing. */
export interface FileOptions {
	/** Of the *low* and the *wind* form, at the most. */
	readonly triangles?: number;
	/** Whether light comes through flesh in the *detailed* and the *instanced* form; readers take another pass for it. */
	readonly translucent?: boolean;
	/** Whether pictures say colours, shade, roughness and relief in the *detailed* form, where vertices and materials do otherwise. */
	readonly textures?: boolean;
	/** That nothing is thinner than in files for printers, millimetres. */
	readonly thickness?: number;
	/** Of a cloud. */
	readonly points?: number;
}

/** What is taken of a number that comes from outside: from the least to the most. */
export const FILE_RANGES = {
	triangles: [100, 2_000_000],
	thickness: [0.2, 20],
	points: [1, 2_000_000],
} as const satisfies Partial<Record<keyof FileOptions, readonly [least: number, most: number]>>;

/** What else of a plant there is than what is seen of it now, for files that move or are seen from afar. */
export interface Further {
	/** The plant at other ages, for what is of its `life`; absent where it has none. */
	readonly aged?: Aged | undefined;
	/** How wind moves it; absent where it stands still. */
	readonly sway?: Sway | undefined;
	/** The plant for several distances; absent of models that make none. */
	readonly levels?: Levels | undefined;
	/** Receives a sentence for each way in which the file differs from what was asked for. */
	readonly note?: ((text: string) => void) | undefined;
}

export interface PlantFile {
	/** Its name for programs: `glb-web`. */
	readonly key: string;
	/** As file names end: `glb`. */
	readonly ending: string;
	/** Which of those that end so, where there are several; the first is meant where nobody says. */
	readonly form?: string;
	readonly title: string;
	/** One line about it. */
	readonly about: string;
	/** After the plant's name. */
	readonly suffix: string;
	/** The media type of the file. */
	readonly type: string;
	/** What of the options it uses. */
	readonly uses?: readonly (keyof FileOptions)[];
	/** Whether it is the file of its kind only where parts share meshes. */
	readonly shared?: true;
	/** Whether making it takes seconds. */
	readonly slow?: true;
	/** Whether it is of the plant at many ages, and so of plants that have any. */
	readonly life?: true;
	/** Whether it is of what wind moves: of what stands still it shows just that. */
	readonly blown?: true;
	/** Whether it is of the plant for several distances, and so of models that make such. */
	readonly levelled?: true;
	/** How it writes instances, for what it may hold (limits.ts); absent of files that are not made from the parts themselves. */
	readonly instances?: WrittenInstances;
	/**
	 * @param parts only read; the same parts and options give the same bytes
	 * @throws FileTooLargeError where the file would be larger than files may be (limits.ts)
	 */
	make(parts: Iterable<Part>, about: About, options: FileOptions, further?: Further): Promise<Uint8Array<ArrayBuffer>>;
}

/** Of the *wind* form, where nobody says otherwise. */
export const WIND_TRIANGLES = 40_000;
/** Of the *low* form, where nobody says otherwise. */
export const LOW_TRIANGLES = 20_000;

/** For printers, where nobody says otherwise: what a nozzle of 0.4 mm prints safely. */
export const THICKNESS = 1;
/** Of a cloud, where nobody says otherwise. */
export const POINTS = 100_000;

const GLB = { ending: "glb", type: "model/gltf-binary" } as const;

const FILES: readonly PlantFile[] = [
	{
		...GLB,
		key: "glb",
		form: "detailed",
		title: "GLB",
		about: "glTF, one node per part; opens everywhere",
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
		title: "GLB for the web",
		about: "At most 5 draw calls, compressed; for readers of EXT_meshopt_compression",
		instances: "meshes",
		suffix: "-web.glb",
		make: async (parts, about) => (await import("./web_glb")).webGlb(parts, about),
	},
	{
		...GLB,
		key: "glb-low",
		form: "low",
		title: "GLB, low",
		about: "As few triangles as you say; opens everywhere",
		instances: "meshes",
		suffix: "-low.glb",
		uses: ["triangles"],
		make: async (parts, about, { triangles }) => (await import("./low_glb")).lowGlb(parts, about, triangles),
	},
	{
		...GLB,
		key: "glb-instanced",
		form: "instanced",
		title: "GLB, instanced",
		about: "Parts that are alike in one node; for readers of EXT_mesh_gpu_instancing",
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
		title: "GLB, growth",
		about: "Its life as an animation; opens everywhere",
		suffix: "-growth.glb",
		life: true,
		slow: true,
		make: async (_, about, __, { aged } = {}) => {
			if (!aged) throw new Error("This plant has no ages to show.");
			return (await import("./growth_glb")).growthGlb(aged, about);
		},
	},
	{
		...GLB,
		key: "glb-wind",
		form: "wind",
		title: "GLB, in the wind",
		about: "Swaying as an animation without end; opens everywhere",
		instances: "meshes",
		suffix: "-wind.glb",
		uses: ["triangles"],
		blown: true,
		slow: true,
		make: async (parts, about, { triangles }, { sway } = {}) =>
			(await import("./wind_glb")).windGlb(parts, about, sway, triangles),
	},
	{
		...GLB,
		key: "glb-lod",
		form: "lod",
		title: "GLB, levels",
		about: "For four distances in one (MSFT_lod); readers that know no levels show the finest",
		suffix: "-lod.glb",
		levelled: true,
		make: async (_, about, __, { levels } = {}) => {
			if (!levels) throw new Error("This plant has no levels.");
			return (await import("./lod_glb")).lodGlb(levels, about);
		},
	},
	{
		key: "usdz",
		ending: "usdz",
		type: "model/vnd.usdz+zip",
		title: "USDZ for phones",
		about: "Universal Scene Description; stands in the room on an iPhone",
		instances: "meshes",
		suffix: ".usdz",
		make: async (parts, about) => (await import("./usdz")).usdz(parts, about),
	},
	{
		key: "ply",
		ending: "ply",
		type: "application/octet-stream",
		title: "PLY points",
		about: "Places, normals and colours, evenly over the surface",
		instances: "meshes",
		suffix: ".ply",
		uses: ["points"],
		make: async (parts, about, { points = POINTS }) => (await import("./ply")).ply(parts, about, points),
	},
	{
		key: "3mf",
		ending: "3mf",
		type: "model/3mf",
		title: "3MF for printers",
		about: "One closed body in millimetres, thick enough to print",
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
		title: "STL for printers",
		about: "The same body for older programs",
		instances: "meshes",
		suffix: ".stl",
		uses: ["thickness"],
		slow: true,
		make: async (parts, about, { thickness = THICKNESS }, { note } = {}) =>
			(await import("./stl")).stl(parts, about, thickness, note),
	},
];

/** Each compares its size with the limit before it is made. */
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

/** The file that a name's ending and perhaps a form mean. */
export function plantFile(ending: string, form?: string): PlantFile | undefined {
	return PLANT_FILES.find((file) => file.ending === ending && (form === undefined || file.form === form));
}

/** Of the kinds that have forms, all forms in a sentence's order. */
export const FORMS = PLANT_FILES.flatMap(({ form }) => form ?? []);
