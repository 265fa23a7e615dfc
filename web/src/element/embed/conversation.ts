/**
 * The message protocol between a host page and the plant in its frame (docs/embed.md). Every message is validated; a
 * response goes only to the origin of the request. Messages of other programs are ignored.
 */
import {
	type FileOptions,
	fileOptionProblem,
	isFileOptionValue,
	type NumericFileOptionKey,
} from "../../formats/file_options";
import { MessageError, messageOf } from "../../locale/message_error";
import { isRecord } from "../../specimen/read_values";
import type { GrownDetail } from "../grown_detail";
import { text } from "../messages.generated";

/** Name and version of the protocol, in every message. */
export const PROTOCOL = "panicle/1";

/** The methods of the plant that requests call. */
export interface EmbeddedPlant {
	readonly specimen: unknown;
	set(values: Readonly<Record<string, number | string>>): Promise<GrownDetail>;
	open(link: string): Promise<GrownDetail>;
	grow(): Promise<GrownDetail>;
	toFile(format: string, options?: FileOptions): Promise<Blob>;
	toBlob(size?: { width?: number; height?: number }): Promise<Blob>;
	resetView(): void;
}

/** The fields of a MessageEvent that are used. */
export interface IncomingMessage {
	readonly data: unknown;
	readonly origin: string;
	readonly source: {
		postMessage(message: unknown, options: { targetOrigin: string }): void;
		/** Whether the window is closed; only windows have this. */
		readonly closed?: boolean;
	} | null;
}

type Values = Readonly<Record<string, unknown>>;
type Method = (plant: EmbeddedPlant, values: Values, message: IncomingMessage) => unknown;

/** An invalid request; the message is the response's error. */
class RequestError extends MessageError {}

const MAX_VALUES = 200;
const LONGEST_ID = 200;
const LONGEST_TEXT = 512 * 1024;
/** Greatest number of listening windows: a page may create any number of frames. */
const MAX_LISTENERS = 64;

export class Conversation {
	readonly #plant: EmbeddedPlant;
	readonly #allowed: readonly string[] | undefined;
	/** Windows that listen to events, with their origins. */
	readonly #listeners = new Map<NonNullable<IncomingMessage["source"]>, string>();

	/** @param allowed origins that may send requests; undefined: all */
	constructor(plant: EmbeddedPlant, allowed?: readonly string[]) {
		this.#plant = plant;
		this.#allowed = allowed;
	}

	/** Responds to a message of the protocol; ignores others; never throws. */
	async receive(message: IncomingMessage): Promise<void> {
		const { data, origin, source } = message;
		if (!isRecord(data) || data.panicle !== PROTOCOL || !source) return;
		const { id } = data;
		if (!(typeof id === "string" ? id.length <= LONGEST_ID : Number.isFinite(id))) return;
		const answer = (more: object) => send(source, origin, { id, ...more });
		try {
			answer({ result: await this.#handleRequest(data, message) });
		} catch (error) {
			const { code, args, text: message } = messageOf(error);
			answer({ error: message, code, args });
		}
	}

	/** Sends an event to all listening windows. */
	broadcast(event: "grown" | "input" | "change" | "error", detail: unknown): void {
		for (const [source, origin] of this.#listeners) send(source, origin, { event, detail });
	}

	/**
	 * Answers a request: checks its origin, then calls the method with the request's values.
	 * @throws RequestError for origins, methods and values that are not allowed
	 */
	async #handleRequest(data: Values, message: IncomingMessage): Promise<unknown> {
		const { origin, source } = message;
		// A page with the origin "null" (a sandbox, a file) cannot be addressed, so it gets no response.
		if (origin === "null" || (this.#allowed && !this.#allowed.includes(origin)))
			throw new RequestError(text.message("embed_origin_refused", { origin }));
		const { method } = data;
		if (method === "listen" && source) {
			this.#listen(source, origin);
			return true;
		}
		const known = typeof method === "string" && Object.hasOwn(METHODS, method) ? METHODS[method] : undefined;
		if (!known)
			throw new RequestError(
				text.message("embed_method_unknown", {
					method: String(JSON.stringify(method)).slice(0, 60),
					methods: NAMES.join(", "),
				}),
			);
		const { values = {} } = data;
		if (!isRecord(values)) throw new RequestError(text.message("embed_values_not_object"));
		return known(this.#plant, values, message);
	}

	/**
	 * Adds a window that receives events, in place of closed ones.
	 * @throws RequestError if too many windows listen
	 */
	#listen(source: NonNullable<IncomingMessage["source"]>, origin: string): void {
		for (const listener of this.#listeners.keys()) if (listener.closed) this.#listeners.delete(listener);
		if (!this.#listeners.has(source) && this.#listeners.size >= MAX_LISTENERS)
			throw new RequestError(text.message("embed_too_many_listeners", { most: MAX_LISTENERS }));
		this.#listeners.set(source, origin);
	}
}

const METHODS: Readonly<Record<string, Method>> = {
	specimen: (plant) => plant.specimen ?? null,
	grow: (plant) => plant.grow(),
	set: (plant, values) => plant.set(settings(values)),
	open: (plant, { link }) => plant.open(textOf("link", link)),
	file: (plant, { format, triangles, thickness, points, translucent, textures }) =>
		plant.toFile(textOf("format", format), {
			...numericOption("triangles", triangles),
			...numericOption("thickness", thickness),
			...numericOption("points", points),
			...(translucent === true ? { translucent } : {}),
			...(textures === true ? { textures } : {}),
		}),
	picture: (plant, { width, height }) =>
		plant.toBlob({
			...(width === undefined ? {} : { width: side("width", width) }),
			...(height === undefined ? {} : { height: side("height", height) }),
		}),
	reset: (plant) => plant.resetView(),
};
const NAMES = ["listen", ...Object.keys(METHODS)];

/**
 * Checks the values of a request `set`: at most `MAX_VALUES` texts and finite numbers.
 * @throws RequestError
 */
function settings(values: Values): Record<string, number | string> {
	const entries = Object.entries(values);
	if (entries.length > MAX_VALUES) throw new RequestError(text.message("embed_too_many_values", { most: MAX_VALUES }));
	return Object.fromEntries(
		entries.map(([key, value]) => [key, typeof value === "number" ? number(key, value) : textOf(key, value)]),
	);
}

/**
 * Returns a value that must be a text of limited length.
 * @throws RequestError
 */
function textOf(key: string, value: unknown): string {
	if (typeof value !== "string" || value.length > LONGEST_TEXT)
		throw new RequestError(text.message("embed_not_text", { key: key.slice(0, 60) }));
	return value;
}

/**
 * Returns a value that must be a finite number.
 * @throws RequestError
 */
function number(key: string, value: unknown): number {
	if (typeof value !== "number" || !Number.isFinite(value))
		throw new RequestError(text.message("embed_not_a_number", { key: key.slice(0, 60) }));
	return value;
}

/**
 * Returns a numeric option of a file, where the message has it; else no option.
 * @throws RequestError where the option does not accept the value
 */
function numericOption(key: NumericFileOptionKey, value: unknown): FileOptions {
	if (value === undefined) return {};
	if (!isFileOptionValue(key, value)) throw new RequestError(fileOptionProblem(key));
	return { [key]: value };
}

/**
 * Returns the side of a picture, 1 to 8192 pixels.
 * @throws RequestError
 */
function side(key: string, value: unknown): number {
	const pixels = number(key, value);
	if (pixels < 1 || pixels > 8192) throw new RequestError(text.message("embed_pixels", { key, least: 1, most: 8192 }));
	return Math.round(pixels);
}

/** Sends a message of the protocol to a window, if it still shows a page of that origin. */
function send(source: NonNullable<IncomingMessage["source"]>, origin: string, message: object): void {
	// Only a page of that origin receives it, even if the window shows another page now.
	if (origin !== "null") source.postMessage({ panicle: PROTOCOL, ...message }, { targetOrigin: origin });
}
