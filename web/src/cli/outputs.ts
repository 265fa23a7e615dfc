/** Files that the command can write for a plant. */
import { basename, dirname, join } from "node:path";
import { aboutPlant } from "../formats/about_plant";
import type { FileOptions } from "../formats/file_options";
import { writeJson } from "../formats/json";
import { writeObj } from "../formats/obj";
import { type Further, PLANT_FILES, plantFile } from "../formats/plant_files";
import { swayed } from "../generate/files/swayed";
import type { Model } from "../models/model";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import type { Specimen } from "../specimen/specimen";

type OutputFile = [file: string, data: string | Uint8Array | readonly Uint8Array[]];

/** Suffixes that every model has. */
const COMMON = [...new Set(PLANT_FILES.map(({ ending }) => ending)), "obj", "json"];

/**
 * Returns the suffix of a format's key: `glb-baked` is `.baked.glb`, so that a form of a common kind of file ends in
 * the kind's suffix, which viewers open.
 */
const endingFor = (key: string) => key.split("-").reverse().join(".");

/** Returns all suffixes of files that a model has, without the first dot. */
const endings = ({ formats = [] }: Pick<Model, "formats">) => [...COMMON, ...formats.map(({ key }) => endingFor(key))];

/** Returns the suffixes that a model has, in words: ".glb, .obj or .json". */
export function endingsOf(model: Pick<Model, "formats">): string {
	const all = endings(model).map((ending) => `.${ending}`);
	return `${all.slice(0, -1).join(", ")} or ${all.at(-1)}`;
}

/** Returns the longest suffix of a file's name that a model has; undefined if it has none of them. */
export function endingOf(model: Pick<Model, "formats">, file: string): string | undefined {
	const found = endings(model).filter((ending) => file.toLowerCase().endsWith(`.${ending}`));
	return found.sort((one, other) => other.length - one.length)[0];
}

/** Returns the model's own format with that suffix; undefined for common ones. */
export function ownFormat({ formats }: Pick<Model, "formats">, ending: string) {
	return formats?.find(({ key }) => endingFor(key) === ending);
}

/**
 * Returns the files of a plant by the suffix of the requested name; an OBJ has its materials and their pictures beside
 * it.
 * @param further the plant at other ages and levels of detail, if any
 */
export async function outputFiles(
	file: string,
	ending: string,
	model: Model,
	grown: Plant,
	specimen: Specimen,
	{ form, ...options }: FileOptions & { form?: string } = {},
	further: Omit<Further, "sway"> = {},
): Promise<OutputFile[]> {
	if (ending === "json") return [[file, jsonOf(model, grown, specimen)]];
	const format = ownFormat(model, ending);
	if (format) return [[file, await format.make(grown, specimen, await encodeLink(model, specimen))]];
	const about = await aboutPlant(model, grown, specimen);
	const meshes = plantFile(ending, form);
	const parts = model.parts(grown, specimen);
	if (meshes)
		return [[file, await meshes.make(parts, about, options, { ...further, sway: swayed(model, grown), plant: grown })]];
	const stem = file.slice(0, -".obj".length);
	const { obj, mtl, pictures } = writeObj(parts, about, basename(stem));
	return [
		[file, obj.chunks()],
		[`${stem}.mtl`, mtl],
		...pictures.map(({ name, bytes }): OutputFile => [join(dirname(stem), name), bytes]),
	];
}

/** Returns the JSON document, one line, in UTF-8, in pieces. */
export function jsonOf(model: Model, grown: Plant, specimen: Specimen): Uint8Array[] {
	const document = writeJson(model, grown, specimen);
	document.word("\n");
	return document.chunks();
}
