/** The base of errors that a user or a program sees. */
import type { Value } from "./format";
import { translated } from "./locale";
import type { Message } from "./texts";

/**
 * An error with a message of a catalogue: `throw new FileError(text.message("file_empty", { name }))`. People read
 * `message`, programs `code` and `args`.
 */
export class MessageError extends Error {
	/** The room and the key of the message: "formats.file_empty". Codes are stable; sentences are not. "": none. */
	readonly code: string;
	/** The arguments of the message by name. */
	readonly args: Readonly<Record<string, Value>>;

	/** @param message a message of a catalogue; or a text, which has no code */
	constructor(message: Message | string, options?: ErrorOptions) {
		const { code, args, text } = typeof message === "string" ? uncoded(message) : message;
		super(text, options);
		this.code = code;
		this.args = args;
	}
}

/** Translates a message from a worker, which knows English only, to the language in use. */
export const translatedMessage = ({ code, args, text }: Message): Message => ({
	code,
	args,
	text: code === "" ? text : translated(code, text, args),
});

/** Returns the message of an error, as workers send it to the page. Other errors have the code "". */
export function messageOf(error: unknown): Message {
	if (error instanceof MessageError) return { code: error.code, args: error.args, text: error.message };
	return uncoded(error instanceof Error ? error.message : String(error));
}

/** Returns a message without a code. */
const uncoded = (text: string): Message => ({ code: "", args: {}, text });
