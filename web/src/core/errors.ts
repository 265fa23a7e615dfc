/** Errors on the way to a grown plant, by type. Every message can be shown, and has a code. */
import { MessageError } from "../locale/message_error";
import type { Message } from "../locale/texts";
import { text } from "./messages.generated";

/** The reason why the core could not grow a request. */
export type CoreReason = "none" | "bad request" | "bad input" | "syntax" | "undefined name" | "evaluation" | "limit";

/** Reasons by the core's codes (wasm-core/src/foundation/result.hpp). */
export const CORE_REASONS: readonly CoreReason[] = [
	"none",
	"bad request",
	"bad input",
	"syntax",
	"undefined name",
	"evaluation",
	"limit",
];

/**
 * The core could not grow the request. Line and column count from 1 in the grammar's text; 0 where no text is
 * concerned.
 */
export class CoreError extends MessageError {
	override name = "CoreError";
	/**
	 * @param message a message of a catalogue; or a text of the core, whose codes are not sentences yet
	 * (`readableError` of generate/readable.ts replaces it)
	 */
	constructor(
		/** The kind of error. */
		readonly reason: CoreReason,
		message: Message | string,
		/** The line in the grammar's text, from 1; 0 where no text is concerned. */
		readonly line = 0,
		/** The column in that line, from 1; 0 where no text is concerned. */
		readonly column = 0,
	) {
		super(message);
	}
}

/** The core crashed; discard the instance. */
export class CoreTrap extends MessageError {
	override name = "CoreTrap";
}

/** Nothing can be grown here; the message names the missing part and a remedy. */
export class UnsupportedError extends MessageError {
	override name = "UnsupportedError";
	constructor(
		/** No WebAssembly; no worker; the core could not be fetched; the fetched file is no core. */
		readonly missing: "webassembly" | "worker" | "fetch" | "core",
		message: Message | string,
		options?: ErrorOptions,
	) {
		super(message, options);
	}
}

/** A newer request replaced this one. Show nothing: the result of the newer one follows. */
export class Superseded extends MessageError {
	override name = "Superseded";
	constructor() {
		super(text.message("superseded"));
	}
}
