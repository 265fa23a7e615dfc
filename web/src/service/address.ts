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
	fileOptionRange,
	isFileOptionValue,
	NUMERIC_FILE_OPTION_KEYS,
	type NumericFileOptionKey,
	SWITCH_FILE_OPTIONS,
} from "../formats/file_options";
import { isModel, modelNamed } from "../models/index";
import type { Model } from "../models/model";
import { decodeLink, modelInQuery } from "../specimen/link";
import type { Note } from "../specimen/notes";
import { isKnown, restore } from "../specimen/restore";
import { SPECIMEN_VERSION, type Specimen } from "../specimen/specimen";
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
const HOW = "write specimens/PRESET.glb?seed=7, or specimens/NAME.glb?v=2&… with a link’s query";

/** Options of the file in a query, with the prefix `file-`: `file-triangles`. */
export const FILE_KEYS = ["triangles", "thickness", "points", "translucent", "textures", "measures", "map"] as const;
type FileKey = (typeof FILE_KEYS)[number];

/** @throws Refused where it is no address of a specimen's file */
export async function readAddress({ pathname, search, href }: URL): Promise<AddressedFile> {
	if (href.length > LONGEST_ADDRESS) throw new Refused(414, `the address is longer than ${LONGEST_ADDRESS} characters`);
	const at = pathname.lastIndexOf(FOLDER);
	if (at < 0) throw new Refused(404, `nothing is here; ${HOW}`);
	const folders = pathname
		.slice(at + FOLDER.length)
		.split("/")
		.map(decoded);
	const file = folders.pop() ?? "";
	const dot = file.indexOf(".");
	if (dot < 1 || folders.length > 1) throw new Refused(404, `“${file.slice(0, 60)}” is no file’s name; ${HOW}`);
	const [name, ending] = [file.slice(0, dot), file.slice(dot + 1).toLowerCase()];
	const [folder] = folders;
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

type Read = Pick<AddressedFile, "model" | "specimen" | "notes">;

async function readLink(query: URLSearchParams): Promise<Read> {
	const model = await modelNamed(modelInQuery(`?${query}`));
	return { model, ...(await decode(model, query)) };
}

async function readPreset(folder: string | undefined, preset: string, query: URLSearchParams): Promise<Read> {
	if (folder !== undefined && !isModel(folder)) throw new Refused(404, `there is no model “${folder.slice(0, 60)}”`);
	const bare = folder === undefined && isModel(preset);
	const model = await modelNamed(bare ? preset : folder);
	if (!bare && !model.presets.named(preset))
		throw new Refused(404, `the ${model.noun} has no preset “${preset.slice(0, 60)}”; there are ${presetsOf(model)}`);
	const unknown = [...query.keys()].filter((key) => !isKnown(model, key) && !packedKeys(model).includes(key));
	const namer = model.details.find(({ named }) => named);
	if (unknown.length > 0 && !namer)
		throw new Refused(400, `${unknown[0].slice(0, 60)}: no parameter of the ${model.noun} has that key`);
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
	if (note) throw new Refused(400, `${note.key}: ${note.problem}`);
	const stranger = await namer?.unknownName?.(specimen);
	if (stranger) throw new Refused(400, `${stranger.name}: ${stranger.problem}`);
	return { model, specimen, notes };
}

/** Decodes a link whose fragment is in the query. */
function decode(model: Model, query: URLSearchParams) {
	const packed = packedKeys(model).flatMap((key) => {
		const text = taken(query, key);
		return text === undefined ? [] : [`${key}=${text}`];
	});
	return decodeLink(model, `?${query}`, packed.length > 0 ? `#${packed.join("&")}` : "");
}

const packedKeys = ({ details }: Model): string[] => details.flatMap(({ packed }) => packed?.link ?? []);

const presetsOf = ({ presets }: Model): string => presets.list.map(({ name }) => name).join(", ");

/** Removes a key, and returns its last value. */
function taken(query: URLSearchParams, key: string): string | undefined {
	const value = query.getAll(key).at(-1);
	query.delete(key);
	return value;
}

function decoded(part: string): string {
	try {
		return decodeURIComponent(part);
	} catch {
		throw new Refused(400, `“${part.slice(0, 60)}” is not written as addresses are`);
	}
}

function optionsOf(own: ReadonlyMap<FileKey, string | undefined>): FileOptions {
	const numbers = NUMERIC_FILE_OPTION_KEYS.map((key) => [key, readNumber(key, own.get(key))]);
	const switches = SWITCH_FILE_OPTIONS.map((key) => [key, readSwitch(key, own.get(key))]);
	return Object.fromEntries([...numbers, ...switches].filter(([, value]) => value !== undefined));
}

function readNumber(key: NumericFileOptionKey, text: string | undefined): number | undefined {
	if (text === undefined) return undefined;
	const value = /^\d+(\.\d+)?$/.test(text) ? Number(text) : Number.NaN;
	if (!isFileOptionValue(key, value)) throw new Refused(400, `file-${key}: ${fileOptionRange(key)}`);
	return value;
}

function readSwitch(key: FileKey, text: string | undefined): boolean | undefined {
	if (text === undefined) return undefined;
	if (text !== "0" && text !== "1") throw new Refused(400, `file-${key}: 0 or 1`);
	return text === "1";
}
