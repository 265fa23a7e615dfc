/**
 * The message protocol between a host page and the plant in its frame (docs/embed.md). Every message is validated; a response goes only to
 * the origin of the request. Messages of other programs are ignored.
 */
import {
	type FileOptions,
	fileOptionRange,
	isFileOptionValue,
	type NumericFileOptionKey,
} from "../../formats/file_options";
import type { GrownDetail } from "../grown_detail";

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
class RequestError extends Error {}

const MOST_VALUES = 200;
const LONGEST_ID = 200;
const LONGEST_TEXT = 512 * 1024;
/** Greatest number of listening windows: a page may create any number of frames. */
const MOST_LISTENERS = 64;

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
			answer({ error: error instanceof Error ? error.message : String(error) });
		}
	}

	/** Sends an event to all listening windows. */
	broadcast(event: "grown" | "input" | "change" | "error", detail: unknown): void {
		for (const [source, origin] of this.#listeners) send(source, origin, { event, detail });
	}

	async #handleRequest(data: Values, message: IncomingMessage): Promise<unknown> {
		const { origin, source } = message;
		// A page with the origin "null" (a sandbox, a file) cannot be addressed, so it gets no response.
		if (origin === "null" || (this.#allowed && !this.#allowed.includes(origin)))
			throw new RequestError(`pages of ${origin} may not ask this frame`);
		const { method } = data;
		if (method === "listen" && source) {
			this.#listen(source, origin);
			return true;
		}
		const known = typeof method === "string" && Object.hasOwn(METHODS, method) ? METHODS[method] : undefined;
		if (!known)
			throw new RequestError(
				`there is no method ${JSON.stringify(method)?.slice(0, 60)}; there are ${NAMES.join(", ")}`,
			);
		const { values = {} } = data;
		if (!isRecord(values)) throw new RequestError("values: an object is wanted");
		return known(this.#plant, values, message);
	}

	#listen(source: NonNullable<IncomingMessage["source"]>, origin: string): void {
		for (const listener of this.#listeners.keys()) if (listener.closed) this.#listeners.delete(listener);
		if (!this.#listeners.has(source) && this.#listeners.size >= MOST_LISTENERS)
			throw new RequestError(`${MOST_LISTENERS} windows listen already; close one, or remove its frame, and try again`);
		this.#listeners.set(source, origin);
	}
}

const METHODS: Readonly<Record<string, Method>> = {
	specimen: (plant) => plant.specimen ?? null,
	grow: (plant) => plant.grow(),
	set: (plant, values) => plant.set(settings(values)),
	open: (plant, { link }) => plant.open(text("link", link)),
	file: (plant, { format, triangles, thickness, points, translucent, textures }) =>
		plant.toFile(text("format", format), {
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

function settings(values: Values): Record<string, number | string> {
	const entries = Object.entries(values);
	if (entries.length > MOST_VALUES) throw new RequestError(`values: more than ${MOST_VALUES}`);
	return Object.fromEntries(
		entries.map(([key, value]) => [key, typeof value === "number" ? number(key, value) : text(key, value)]),
	);
}

function text(key: string, value: unknown): string {
	if (typeof value !== "string" || value.length > LONGEST_TEXT)
		throw new RequestError(`${key.slice(0, 60)}: a text is wanted`);
	return value;
}

function number(key: string, value: unknown): number {
	if (typeof value !== "number" || !Number.isFinite(value))
		throw new RequestError(`${key.slice(0, 60)}: a number is wanted`);
	return value;
}

/** A numeric option of a file, where the message has it. */
function numericOption(key: NumericFileOptionKey, value: unknown): FileOptions {
	if (value === undefined) return {};
	if (!isFileOptionValue(key, value)) throw new RequestError(`${key}: ${fileOptionRange(key)}`);
	return { [key]: value };
}

function side(key: string, value: unknown): number {
	const pixels = number(key, value);
	if (pixels < 1 || pixels > 8192) throw new RequestError(`${key}: 1 to 8192 pixels`);
	return Math.round(pixels);
}

function isRecord(value: unknown): value is Values {
	return typeof value === "object" && value !== null && !Array.isArray(value);
}

function send(source: NonNullable<IncomingMessage["source"]>, origin: string, message: object): void {
	// Only a page of that origin receives it, even if the window shows another page now.
	if (origin !== "null") source.postMessage({ panicle: PROTOCOL, ...message }, { targetOrigin: origin });
}
