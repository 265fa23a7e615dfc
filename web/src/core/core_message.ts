/**
 * Messages of the core. The core sends codes with arguments (wasm-core/src/foundation/message.hpp); the sentences are
 * in the catalogues of its rooms (wasm-core/src/<room>/messages.json), which are loaded with the first message.
 */
import type { Value } from "../locale/format";
import { translated } from "../locale/locale";
import type { Message } from "../locale/texts";

const START = "\x02";
const SEPARATOR = "\x1f";
const END = "\x03";

type CoreCatalogue = typeof import("./core_messages.generated");
let catalogue: CoreCatalogue | undefined;

/**
 * Loads the catalogue: await it before `coreText` and `coreMessage`. Where it cannot be fetched, these return codes and
 * arguments in place of sentences, so that a plant can be shown without its notes' sentences; the next call tries
 * again.
 */
export async function loadCoreMessages(): Promise<void> {
	try {
		catalogue ??= await import("./core_messages.generated");
	} catch {
		// Codes are shown.
	}
}

/** Returns whether a text contains messages of the core. */
export const holdsMessage = (text: string): boolean => text.includes(START);

/** Replaces each message of the core in a text by its sentence; other text stays as it is. */
export function coreText(text: string): string {
	if (!holdsMessage(text)) return text;
	const reader = new Reader(text);
	return reader.text();
}

/** Returns the message of the core that a text is; undefined for plain text. */
export function coreMessage(text: string): Message | undefined {
	return text.startsWith(START) ? new Reader(text).message() : undefined;
}

class Reader {
	readonly #text: string;
	#at = 0;

	constructor(text: string) {
		this.#text = text;
	}

	/** Returns the whole text with each message replaced by its sentence. */
	text(): string {
		let out = "";
		while (this.#at < this.#text.length) {
			if (this.#text[this.#at] === START) out += this.message().text;
			else out += this.#text[this.#at++];
		}
		return out;
	}

	/**
	 * Reads the message at the current position, which is its START character, and translates it. Its parts are the code
	 * and the arguments, separated by SEPARATOR and closed by END; an argument may contain messages, which are translated
	 * first.
	 */
	message(): Message {
		this.#at++;
		const parts = [""];
		while (this.#at < this.#text.length) {
			const next = this.#text[this.#at];
			if (next === START) {
				parts[parts.length - 1] += this.message().text;
				continue;
			}
			this.#at++;
			if (next === END) break;
			if (next === SEPARATOR) parts.push("");
			else parts[parts.length - 1] += next;
		}
		const [code, ...values] = parts;
		return messageOf(`core.${code}`, values);
	}
}

/** Converts whole numbers, so that they are written with the separators of the language; other texts remain. */
const argumentOf = (text: string): Value => (/^-?\d{1,15}$/.test(text) ? Number(text) : text);

/**
 * Returns the message of a code such as "room.key", translated; where the catalogue is not loaded, its text is code and
 * values.
 */
function messageOf(code: string, values: readonly string[]): Message {
	const dot = code.lastIndexOf(".");
	const [room, key] = [code.slice(0, dot), code.slice(dot + 1)];
	const entry = catalogue?.CORE_MESSAGES[room]?.[key];
	const names = catalogue?.CORE_ARGUMENTS[room]?.[key] ?? [];
	const args = Object.fromEntries(names.map((name, i) => [name, argumentOf(values[i] ?? "")]));
	const english = typeof entry === "function" ? entry(args) : (entry ?? [code, ...values].join(" "));
	return { code, args, text: translated(code, english, args) };
}
