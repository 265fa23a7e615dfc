/**
 * The address of a specimen's file, in two forms:
 * - `specimens/riesling.glb?seed=7&age=80`, `specimens/leaf/oak.low.glb?file-triangles=5000`, `specimens/tree.json`: a
 *   preset, with differences in the query: parameters, and values for names in the text of a grammar or a flower. Users
 *   type it: unusable values are refused.
 * - `specimens/any-name.glb?v=2&preset=riesling&seed=7`, `specimens/v=2&preset=riesling&seed=7/any-name.glb`: a link,
 *   in the query or as a folder, so that a file's neighbours (an OBJ's materials) have addresses beside it. Links stay
 *   valid: unusable values are brought into range as everywhere, with a note. Texts of a link's fragment, which
 *   browsers do not send to servers, are further keys: `g=…`.
 */
import {
	type FileOptions,
	fileOptionProblem,
	isFileOptionValue,
	NUMERIC_FILE_OPTION_KEYS,
	type NumericFileOptionKey,
	SWITCH_FILE_OPTIONS,
} from "../formats/file_options";
import type { Message } from "../locale/texts";
import { isModel, modelNamed, modelNames } from "../models/index";
import type { Model } from "../models/model";
import { decodeLink, modelInQuery } from "../specimen/link";
import type { Note } from "../specimen/notes";
import { isKnown, restore } from "../specimen/restore";
import { SPECIMEN_VERSION, type Specimen } from "../specimen/specimen";
import { text } from "./messages.generated";
import { Refused } from "./refused";

/** A request for a specimen's file. */
export interface AddressedFile {
	readonly model: Model;
	readonly specimen: Specimen;
	/** Notes on parts of a link that could not be used. */
	readonly notes: readonly Note[];
	/** The file's name up to its first dot. */
	readonly name: string;
	/** The suffix after that dot, lower case: `low.glb`. */
	readonly ending: string;
	/** Whether files beside it have addresses, too: the link is a folder. */
	readonly neighbours: boolean;
	readonly options: FileOptions;
	/** Whether a JSON document gets measures. */
	readonly measures: boolean;
	/** Whether a JSON document gets the whole topology, for models that have one. */
	readonly map: boolean;
}

/** The most characters of an address. */
export const LONGEST_ADDRESS = 24 * 1024;
/** The folder of all specimens. */
const FOLDER = "/specimens/";

/** Options of the file in a query, with the prefix `file-`: `file-triangles`. */
export const FILE_KEYS = ["triangles", "thickness", "points", "translucent", "textures", "measures", "map"] as const;
type FileKey = (typeof FILE_KEYS)[number];

/**
 * Reads an address of either form.
 * @throws Refused where it is no address of a specimen's file
 */
export async function readAddress({ pathname, search, href }: URL): Promise<AddressedFile> {
	if (href.length > LONGEST_ADDRESS)
		throw new Refused(414, text.message("address_too_long", { most: LONGEST_ADDRESS }));
	const at = pathname.lastIndexOf(FOLDER);
	if (at < 0) throw new Refused(404, text.message("not_found", { advice: text("how_to_address") }));
	const folders = pathname
		.slice(at + FOLDER.length)
		.split("/")
		.map(decoded);
	const file = folders.pop() ?? "";
	const dot = file.indexOf(".");
	if (dot < 1 || folders.length > 1) {
		const named = { file: file.slice(0, 60), advice: text("how_to_address") };
		throw new Refused(404, text.message("not_a_file_name", named));
	}
	const [name, ending] = [file.slice(0, dot), file.slice(dot + 1).toLowerCase()];
	const [folder] = folders;
	// A folder with “=” is a link's query in the path.
	const query = new URLSearchParams(folder?.includes("=") ? `${folder}&${search.slice(1)}` : search);
	const own = new Map(FILE_KEYS.map((key) => [key, taken(query, `file-${key}`)]));
	const read = query.has("v") ? await readLink(query) : await readPreset(folder, name, query);
	return {
		...read,
		name,
		ending,
		neighbours: folder?.includes("=") === true,
		options: optionsOf(own),
		measures: readSwitch("measures", own.get("measures")) ?? true,
		map: readSwitch("map", own.get("map")) ?? true,
	};
}

/** Whether an address is the folder of all specimens, which answers with the catalogue of models. */
export const isCatalogue = ({ pathname }: URL): boolean => pathname.endsWith(FOLDER);

type Read = Pick<AddressedFile, "model" | "specimen" | "notes">;

/** Reads an address that has the query of a link: the specimen of the link. */
async function readLink(query: URLSearchParams): Promise<Read> {
	const model = await modelNamed(modelInQuery(`?${query}`));
	return { model, ...(await decode(model, query)) };
}

/**
 * Reads an address such as `specimens/leaf/oak.glb?seed=7`: the path names a model's folder and a preset, or only one
 * of them; the query has parameters and names that the preset's text defines. Everything unusable is refused.
 */
async function readPreset(folder: string | undefined, preset: string, query: URLSearchParams): Promise<Read> {
	if (folder !== undefined && !isModel(folder)) {
		const named = { model: folder.slice(0, 60), models: modelNames().join(", ") };
		throw new Refused(404, text.message("model_unknown", named));
	}
	const bare = folder === undefined && isModel(preset);
	const model = await modelNamed(bare ? preset : folder);
	if (!bare && !model.presets.named(preset)) {
		const named = { model: model.name, preset: preset.slice(0, 60), presets: presetsOf(model) };
		throw new Refused(404, text.message("preset_unknown", named));
	}
	const unknown = [...query.keys()].filter((key) => !isKnown(model, key) && !packedKeys(model).includes(key));
	const namer = model.details.find(({ named }) => named);
	if (unknown.length > 0 && !namer)
		throw new Refused(400, text.message("parameter_unknown", { model: model.name, key: unknown[0].slice(0, 60) }));
	// Keys that are no parameters are names in the preset's text, which the rest of the query determines.
	const own = Object.fromEntries(unknown.map((key) => [key, taken(query, key) ?? ""]));
	const start = [
		["v", `${SPECIMEN_VERSION}`],
		["model", model.name],
		["preset", bare ? model.presets.standard : preset],
	];
	const named = new URLSearchParams([...start, ...query]);
	const { specimen: linked, notes } = await decode(model, named);
	const { specimen, notes: more } = restore(model, namer?.named?.(linked, own), linked);
	const [note] = [...notes, ...more];
	if (note) throw atKey(note.key, { ...note, text: note.problem });
	const stranger = await namer?.unknownName?.(specimen);
	if (stranger) throw atKey(stranger.name, stranger.problem);
	return { model, specimen, notes };
}

/** Decodes a link whose fragment is in the query. */
function decode(model: Model, query: URLSearchParams) {
	const packed = packedKeys(model).flatMap((key) => {
		const value = taken(query, key);
		return value === undefined ? [] : [`${key}=${value}`];
	});
	return decodeLink(model, `?${query}`, packed.length > 0 ? `#${packed.join("&")}` : "");
}

/** Returns the refusal of a key's value. */
const atKey = (key: string, { code, args, text: problem }: Message): Refused =>
	new Refused(400, { code, args, text: text("at_key", { key, problem }) });

/** Returns the keys of a link's fragment that hold packed texts. */
const packedKeys = ({ details }: Model): string[] => details.flatMap(({ packed }) => packed?.link ?? []);

/** Returns the names of a model's presets, for a message. */
const presetsOf = ({ presets }: Model): string => presets.list.map(({ name }) => name).join(", ");

/** Removes a key from a query, and returns its last value; undefined where there was none. */
function taken(query: URLSearchParams, key: string): string | undefined {
	const value = query.getAll(key).at(-1);
	query.delete(key);
	return value;
}

/**
 * Decodes a part of a path.
 * @throws Refused where its percent-encoding is invalid
 */
function decoded(part: string): string {
	try {
		return decodeURIComponent(part);
	} catch {
		throw new Refused(400, text.message("badly_encoded", { part: part.slice(0, 60) }));
	}
}

/**
 * Reads the options of the file, without absent ones.
 * @throws Refused
 */
function optionsOf(own: ReadonlyMap<FileKey, string | undefined>): FileOptions {
	const numbers = NUMERIC_FILE_OPTION_KEYS.map((key) => [key, readNumber(key, own.get(key))]);
	const switches = SWITCH_FILE_OPTIONS.map((key) => [key, readSwitch(key, own.get(key))]);
	return Object.fromEntries([...numbers, ...switches].filter(([, value]) => value !== undefined));
}

/**
 * Reads a numeric option; undefined where it is absent.
 * @throws Refused where the option does not accept the value
 */
function readNumber(key: NumericFileOptionKey, written: string | undefined): number | undefined {
	if (written === undefined) return undefined;
	const value = /^\d+(\.\d+)?$/.test(written) ? Number(written) : Number.NaN;
	if (!isFileOptionValue(key, value)) throw new Refused(400, fileOptionProblem(key, `file-${key}`));
	return value;
}

/**
 * Reads an option that is `0` or `1`; undefined where it is absent.
 * @throws Refused for any other value
 */
function readSwitch(key: FileKey, written: string | undefined): boolean | undefined {
	if (written === undefined) return undefined;
	if (written !== "0" && written !== "1")
		throw new Refused(400, text.message("switch_value", { option: `file-${key}` }));
	return written === "1";
}
