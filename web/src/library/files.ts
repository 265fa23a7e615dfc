/** Files of grown specimens: all that the app's Download and the command line write, except pictures. */
import { aboutPlant } from "../formats/about_plant";
import {
	type FileOptions,
	fileOptionProblem,
	isFileOptionValue,
	NUMERIC_FILE_OPTION_KEYS,
} from "../formats/file_options";
import { exportJson, type OrganRecord, type SegmentRecord } from "../formats/json";
import { exportObj } from "../formats/obj";
import { hasAges } from "../generate/files/aged";
import { makeFile } from "../generate/files/make";
import { modelNamed } from "../models/index";
import type { Model } from "../models/model";
import type { Part } from "../plant/part";
import type { Specimen as Held } from "../specimen/specimen";
import { formats } from "./catalogue";
import { type Grown, growHeld, type Specimen } from "./grow";
import { text } from "./messages.generated";
import { readTyped, SpecimenError } from "./read_request";

/** The forms of a GLB: docs/export.md describes them. */
export type GlbForm = "detailed" | "web" | "low" | "instanced" | "growth" | "wind" | "lod";

/** Options of a GLB. */
export interface GlbOptions {
	/**
	 * `detailed` where absent. `web` and `instanced` are for readers of extensions of glTF, `growth` is the plant's
	 * life as an animation, `wind` its swaying, `lod` a tree of `growth` at four levels of detail (MSFT_lod).
	 */
	readonly form?: GlbForm;
	/** The most triangles of the form `low`, 20,000 where absent, and of the form `wind`, 40,000 where absent. */
	readonly triangles?: number;
	/**
	 * Whether light passes through flesh in the forms `detailed` and `instanced`; readers need an extra pass for it.
	 */
	readonly translucent?: boolean;
	/** Whether pictures hold colours and shade in the form `detailed`, in place of vertices. */
	readonly textures?: boolean;
}

/** An OBJ with the files beside it. */
export interface ObjFiles {
	/** The text of `NAME.obj`; it refers to `NAME.mtl`. */
	readonly obj: string;
	/** The text of `NAME.mtl`. */
	readonly mtl: string;
	/** The pictures that the MTL refers to, PNGs by the names of their files. */
	readonly pictures: readonly { readonly name: string; readonly bytes: Uint8Array<ArrayBuffer> }[];
}

/**
 * The JSON document of a plant, as in docs/command-line.md. Lengths in metres; each number reads back as the same
 * float32.
 */
export interface PlantDocument {
	/** The program that wrote it, with its version. */
	readonly generator: string;
	/** The specimen that it grew from. */
	readonly specimen: Specimen;
	/** Counts by name. */
	readonly counts: Readonly<Record<string, number>>;
	/** By key; null where one does not apply. */
	readonly measures: Readonly<Record<string, number | null>>;
	/** Classes of descriptors by the keys of their measures, with the code of the OIV; absent where there are none. */
	readonly classes?: Readonly<Record<string, { readonly oiv: number; readonly class: number; readonly words: string }>>;
	/**
	 * One per drawn module, parents first; absent where nothing was drawn. A model may use fields of its own in their
	 * place.
	 */
	readonly segments?: readonly SegmentRecord[];
	/** Leaves, fruits and flowers; absent where there are none. */
	readonly organs?: readonly OrganRecord[];
	/** Messages in plain sentences. */
	readonly notes: readonly string[];
	/** As in `Grown`; it can be computed again from the document. */
	readonly fingerprint: string;
	/** Fields of the model. */
	readonly [own: string]: unknown;
}

/**
 * A GLB: glTF 2.0 in one file, metres, +Y up. The same plant and options give the same bytes.
 * @param grown - a plant with meshes
 * @param options - its form and options of the form
 * @throws SpecimenError where the plant was grown without meshes, or has no ages for the form `growth`
 *
 * @example
 * ```js
 * const light = await toGLB(bunch, { form: "low", triangles: 5000 });
 * ```
 */
export function toGLB(grown: Grown, options: GlbOptions = {}): Promise<Uint8Array<ArrayBuffer>> {
	const { form = "detailed", ...others } = options;
	return bytesOf(grown, form === "detailed" ? "glb" : `glb-${form}`, others);
}

/**
 * A USDZ, which phones show in augmented reality.
 * @param grown - a plant with meshes
 * @throws SpecimenError where the plant was grown without meshes
 */
export function toUSDZ(grown: Grown): Promise<Uint8Array<ArrayBuffer>> {
	return bytesOf(grown, "usdz");
}

/**
 * A 3MF for printers: one closed body in millimetres. Takes seconds.
 * @param grown - a plant with meshes
 * @param options - `thickness`: the least thickness, in millimetres; 1 where absent
 * @throws SpecimenError where the plant was grown without meshes
 */
export function to3MF(grown: Grown, options: { readonly thickness?: number } = {}): Promise<Uint8Array<ArrayBuffer>> {
	return bytesOf(grown, "3mf", options);
}

/**
 * An STL of the same body as in `to3MF`, for older programs.
 * @param grown - a plant with meshes
 * @param options - `thickness`: the least thickness, in millimetres; 1 where absent
 * @throws SpecimenError where the plant was grown without meshes
 */
export function toSTL(grown: Grown, options: { readonly thickness?: number } = {}): Promise<Uint8Array<ArrayBuffer>> {
	return bytesOf(grown, "stl", options);
}

/**
 * A PLY of points spread evenly over the surface, with normals and colours.
 * @param grown - a plant with meshes
 * @param options - `points`: their number; 100,000 where absent
 * @throws SpecimenError where the plant was grown without meshes
 */
export function toPLY(grown: Grown, options: { readonly points?: number } = {}): Promise<Uint8Array<ArrayBuffer>> {
	return bytesOf(grown, "ply", options);
}

/**
 * An OBJ, its MTL and their pictures: metres, +Y up.
 * @param grown - a plant with meshes
 * @param name - the name of the files, without a suffix; the preset's name where absent
 * @throws SpecimenError where the plant was grown without meshes
 */
export async function toOBJ(grown: Grown, name = grown.specimen.preset): Promise<ObjFiles> {
	const { model, specimen } = await typedSpecimenOf(grown);
	checkMeshes(grown);
	const about = await aboutPlant(model, grown.plant, specimen, grown.link);
	return exportObj(model.parts(grown.plant, specimen), about, name);
}

/**
 * The plant as a document of plain JSON: every part as numbers, measures, and its specimen.
 * @param grown - a plant, with or without meshes
 */
export async function toJSON(grown: Grown): Promise<PlantDocument> {
	const { model, specimen } = await typedSpecimenOf(grown);
	return exportJson(model, { ...grown.plant, notes: [...grown.notes] }, specimen) as unknown as PlantDocument;
}

/**
 * A file of any kind that `formats(model)` lists: those above, an OBJ with all its files in a ZIP, and the model's own,
 * such as a bunch's `csv` or a leaf's `svg`.
 * @param grown - a plant; with meshes, except for `json` and tables
 * @param format - the key of the kind
 * @param options - options; the kind ignores those that it does not use
 * @returns the file, with its media type
 * @throws SpecimenError where there is no such kind for this plant, or a number in `options` is out of its range
 */
export async function toFile(grown: Grown, format: string, options: FileOptions = {}): Promise<Blob> {
	const { model, specimen } = await typedSpecimenOf(grown);
	if (!(await formats(model.name)).some(({ key }) => key === format))
		throw new SpecimenError("format", text.message("format_unknown", { model: model.name, format }));
	checkRanges(options);
	const own = model.formats?.find(({ key }) => key === format);
	if (!own && format !== "json") checkMeshes(grown);
	if (own?.applies?.(grown.plant) === false)
		throw new SpecimenError("format", text.message("format_not_for_plant", { format }));
	// Whether a plant depends on its age is known only with the resources that `prepare` fetches, such as a text.
	if (format === "glb-growth") await model.prepare?.(specimen);
	if (format === "glb-growth" && !hasAges(model, specimen)) throw new SpecimenError("format", text.message("no_ages"));
	if (format === "glb-lod" && !model.levels) throw new SpecimenError("format", text.message("no_levels"));
	const { link } = grown;
	const plant = { ...grown.plant, notes: [...grown.notes] };
	const request = { model: model.name, format, grown: plant, specimen, link, name: specimen.preset, options };
	return makeFile(model, request, (other, wanted) =>
		growHeld(model, other, { meshes: true, measures: false, ...wanted }),
	);
}

/**
 * The parts of a plant, as in all files with meshes: named meshes or instances, each with its material.
 * @param grown - a plant with meshes
 * @returns the parts, which share meshes, arrays and materials by sharing the objects; do not change them
 * @throws SpecimenError where the plant was grown without meshes
 */
export async function partsOf(grown: Grown): Promise<Part[]> {
	const { model, specimen } = await typedSpecimenOf(grown);
	checkMeshes(grown);
	return [...model.parts(grown.plant, specimen)];
}

/**
 * Checks the numbers of options.
 * @throws SpecimenError at the first that is out of its range
 */
function checkRanges(options: FileOptions): void {
	for (const key of NUMERIC_FILE_OPTION_KEYS) {
		const value = options[key];
		if (value !== undefined && !isFileOptionValue(key, value))
			throw new SpecimenError(key, fileOptionProblem(key, `options.${key}`));
	}
}

/** Makes a file and returns its bytes. */
async function bytesOf(grown: Grown, format: string, options: FileOptions = {}): Promise<Uint8Array<ArrayBuffer>> {
	return new Uint8Array(await (await toFile(grown, format, options)).arrayBuffer());
}

/** Returns the specimen with the model's own types: it may have come through a message, or from a file. */
async function typedSpecimenOf({ specimen }: Grown): Promise<{ model: Model; specimen: Held }> {
	const model = await modelNamed(specimen.model);
	return { model, specimen: readTyped(model, specimen) };
}

/**
 * Checks that a plant has meshes.
 * @throws SpecimenError where it was grown without
 */
function checkMeshes({ meshes }: Grown): void {
	if (meshes) return;
	throw new SpecimenError("meshes", text.message("no_meshes"));
}
