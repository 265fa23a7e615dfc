/**
 * Answers HTTP requests for specimens by their addresses. It stores nothing: the same address gives the same plant on a
 * server, in a service worker or in a test.
 */

import type { Core } from "../core/core";
import { CoreCache } from "../core/cores";
import { CoreError } from "../core/errors";
import { aboutPlant } from "../formats/about_plant";
import { crc32Digits } from "../formats/crc32";
import { EmptyPlantError, FileTooLargeError } from "../formats/file_error";
import { writeJson } from "../formats/json";
import { writeObj } from "../formats/obj";
import { PLANT_FILES } from "../formats/plant_files";
import { hasAges } from "../generate/files/aged";
import type { GrowSpecimen } from "../generate/files/levelled";
import { makeFile } from "../generate/files/make";
import { growPlant, untimed } from "../generate/growth";
import { messageOf } from "../locale/message_error";
import type { Message } from "../locale/texts";
import { catalogue } from "../models/catalogue";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import { type AddressedFile, isCatalogue, readAddress } from "./address";
import { text } from "./messages.generated";
import { ERROR_HEADERS, errorBody, Refused } from "./refused";
import { TagCache } from "./tag_cache";

/** The environment of the service. */
export interface ServiceEnvironment {
	/** @param wasm the file of a model's core: `bunch.wasm` */
	loadCore(wasm: string): Promise<Core>;
	/** The version of the writers: files of the same plant may differ between releases. */
	readonly release: string;
}

/** Answers a request; never throws. */
export type Service = (request: Request) => Promise<Response>;

/** HTTP methods that are supported. */
export const METHODS = ["GET", "HEAD", "OPTIONS"];
/** Any page may send requests: answers are public, and the same for all. */
const FOR_ALL = {
	"access-control-allow-origin": "*",
	"access-control-expose-headers": "etag, content-disposition",
	"cross-origin-resource-policy": "cross-origin",
	"x-content-type-options": "nosniff",
};
/** A plant stays the same, but files may improve: revalidate after an hour, and use the old file meanwhile. */
const CACHING = "public, max-age=3600, stale-while-revalidate=86400";
/** Further kinds of files: an OBJ alone, its materials, and an archive of both with their pictures. */
const OTHERS = ["json", "obj", "mtl", "zip-obj"];
/** A picture of the materials, whose name begins with theirs. */
const OF_OBJ = "png-obj";
const OF_MATERIAL = /-(?:colour|normal)$/;
const encoder = new TextEncoder();

/**
 * Creates the service. It remembers ETags of the last addresses, so that an unchanged plant need not be grown again.
 */
export function makeService({ loadCore, release }: ServiceEnvironment): Service {
	const cores = new CoreCache(loadCore);
	const known = new TagCache(4096);
	const run = cores.grow.bind(cores);

	/** Grows a plant with its members; errors that the core reports are refused with status 422. */
	async function grow(
		{ model, specimen, notes }: AddressedFile,
		options: { meshes: boolean; measures: boolean; map: boolean },
	): Promise<Plant> {
		try {
			const grown = untimed(await growPlant(model, specimen, options, run));
			return { ...grown, notes: [...grown.notes, ...notes.map((note) => note.text)] };
		} catch (error) {
			if (error instanceof CoreError) throw new Refused(422, placed(error));
			throw error;
		}
	}

	/**
	 * Answers one request.
	 * @throws Refused with the status to send
	 */
	async function answer(request: Request): Promise<Response> {
		const { method } = request;
		if (method === "OPTIONS")
			return new Response(null, { status: 204, headers: { ...FOR_ALL, allow: METHODS.join(", ") } });
		if (!METHODS.includes(method))
			throw new Refused(405, text.message("method_not_allowed", { method }), { allow: METHODS.join(", ") });
		const url = new URL(request.url);
		if (isCatalogue(url)) return listed(request);
		const target = await readAddress(url);
		const format = await formatOf(target);
		const link = await encodeLink(target.model, target.specimen);
		const address = JSON.stringify([link, format, target.options, target.measures, target.map, release]);
		const before = known.tag(address);
		// Without a growth, if the client has the file and the tag of this address is still known.
		if (before && matches(request, before)) return unchanged(before);
		const json = format === "json";
		const map = target.map && json;
		if (map && target.model.heavy) {
			// Check the size first, without measures and topology; the core caches the grown plant.
			const heavy = target.model.heavy(await grow(target, { meshes: false, measures: false, map: false }));
			if (heavy !== undefined) throw new Refused(413, heavy);
		}
		const plant = await grow(target, { meshes: !json, measures: target.measures, map });
		// The tag depends on the plant and on the way it is written.
		const tag = `"${plant.fingerprint}-${crc32Digits(encoder.encode(address))}"`;
		known.keep(address, tag);
		if (matches(request, tag)) return unchanged(tag);
		const file = await fileOf(target, format, plant, (other, wanted) =>
			growPlant(target.model, other, { measures: false, ...wanted }, run),
		).catch((error: unknown) => {
			if (error instanceof EmptyPlantError) throw new Refused(422, messageOf(error));
			throw error instanceof FileTooLargeError ? new Refused(413, messageOf(error)) : error;
		});
		const headers = {
			...FOR_ALL,
			etag: tag,
			"cache-control": CACHING,
			"content-type": file.type,
			"content-length": `${file.size}`,
		};
		return new Response(method === "HEAD" ? null : file, { headers });
	}

	return async (request) => {
		try {
			return await answer(request);
		} catch (error) {
			return refusal(error);
		}
	};
}

/** Answers with all models, their presets and parameters as JSON. */
async function listed({ method }: Request): Promise<Response> {
	const headers = { ...FOR_ALL, "cache-control": CACHING, "content-type": "application/json" };
	return new Response(method === "HEAD" ? null : JSON.stringify(await catalogue()), { headers });
}

/** Returns the key of the kind of file for a suffix: `low.glb` is `glb-low`. */
async function formatOf({ model, specimen, name, ending, neighbours }: AddressedFile): Promise<string> {
	const key = ending.split(".").reverse().join("-");
	const all = [...PLANT_FILES.map((file) => file.key), ...OTHERS, ...(model.formats ?? []).map((each) => each.key)];
	const file = PLANT_FILES.find((each) => each.key === key);
	if (file?.life) await model.prepare?.(specimen);
	if (file?.life && !hasAges(model, specimen)) throw new Refused(404, text.message("no_ages"));
	if (file?.levelled && !model.levels) throw new Refused(404, text.message("no_levels"));
	if (all.includes(key)) return key;
	if (ending === "png" && neighbours && OF_MATERIAL.test(name)) return OF_OBJ;
	if (/^(png|jpe?g|webp|avif|gif)$/.test(ending)) throw new Refused(501, text.message("no_pictures"));
	const files = all.map((each) => `.${each.split("-").reverse().join(".")}`).join(", ");
	throw new Refused(404, text.message("file_unknown", { file: `.${ending.slice(0, 20)}`, model: model.name, files }));
}

/**
 * Makes the file of a format; OBJ consists of several files, each of which can be requested.
 * @param growing grows other specimens that a format needs
 */
async function fileOf(
	{ model, specimen, name, neighbours, options }: AddressedFile,
	format: string,
	grown: Plant,
	growing: GrowSpecimen,
): Promise<Blob> {
	if (format === "json") return new Blob(writeJson(model, grown, specimen).chunks(), { type: "application/json" });
	const link = await encodeLink(model, specimen);
	if (format === "obj" || format === "mtl") {
		const about = await aboutPlant(model, grown, specimen, link);
		const { obj, mtl } = writeObj(model.parts(grown, specimen), about, name, neighbours);
		return new Blob(format === "obj" ? obj.chunks() : [mtl], { type: `model/${format}` });
	}
	if (format === OF_OBJ)
		return picture(writeObj(model.parts(grown, specimen), await aboutPlant(model, grown, specimen, link), ""), name);
	const key = format === "zip-obj" ? "obj" : format;
	const request = { model: model.name, format: key, grown, specimen, link, name, options };
	return makeFile(model, request, growing);
}

/**
 * Returns the picture of an MTL of any name, by the end of its name: material and kind.
 * @param name the requested file's name without suffix
 * @throws Refused where there is no such picture
 */
function picture({ pictures }: ReturnType<typeof writeObj>, name: string): Blob {
	const meant = pictures.filter((each) => `${name}.png`.endsWith(each.name));
	const [found] = meant.sort((one, other) => other.name.length - one.name.length);
	if (!found) throw new Refused(404, text.message("picture_unknown", { picture: `${name.slice(0, 60)}.png` }));
	return new Blob([found.bytes], { type: "image/png" });
}

/** Returns the core's error message with its position in the grammar, in the form of compilers. */
function placed(error: CoreError): Message {
	const message = messageOf(error);
	if (error.line === 0) return message;
	const place = { line: String(error.line), column: String(error.column), problem: message.text };
	return { ...message, text: text("at_grammar", place) };
}

/** Returns whether the client already has the file with this entity tag (`If-None-Match`). */
function matches(request: Request, tag: string): boolean {
	const tags = request.headers.get("if-none-match")?.split(",") ?? [];
	return tags.some((each) => ["*", tag].includes(each.trim().replace(/^W\//, "")));
}

/** Returns the answer that the client's own copy is still valid. */
function unchanged(tag: string): Response {
	return new Response(null, { status: 304, headers: { ...FOR_ALL, etag: tag, "cache-control": CACHING } });
}

/** Returns the answer to a request that is refused; any other error than `Refused` is an internal one. */
function refusal(error: unknown): Response {
	const refused = error instanceof Refused ? error : undefined;
	const headers = { ...FOR_ALL, ...ERROR_HEADERS, ...refused?.headers };
	const message = refused ? messageOf(refused) : text.message("internal_error");
	return new Response(errorBody(message), { status: refused?.status ?? 500, headers });
}
