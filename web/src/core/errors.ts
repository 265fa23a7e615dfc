/** What can go wrong on the way to a grown plant, by type. Every message is one plain sentence that can be shown. */

/** Why the core could not grow a request. */
export type CoreReason = "none" | "bad request" | "bad input" | "syntax" | "undefined name" | "evaluation" | "limit";

/** The same by the codes that the core gives (wasm-core/src/foundation/result.hpp). */
export const CORE_REASONS: readonly CoreReason[] = [
	"none",
	"bad request",
	"bad input",
	"syntax",
	"undefined name",
	"evaluation",
	"limit",
];

/** The core could not grow the request. Line and column count from 1 in the grammar's text; 0 where none is concerned. */
export class CoreError extends Error {
	override name = "CoreError";
	constructor(
		/** What kind of fault it is. */
		readonly reason: CoreReason,
		message: string,
		/** In the grammar's text, from 1; 0 where no text is concerned. */
		readonly line = 0,
		/** In that line, from 1; 0 where no text is concerned. */
		readonly column = 0,
	) {
		super(message);
	}
}

/** The core stopped half-way, which it never should: the instance is of no further use. */
export class CoreTrap extends Error {
	override name = "CoreTrap";
}

/** Nothing can be grown here: what is missing, and what to do about it. */
export class UnsupportedError extends Error {
	override name = "UnsupportedError";
	constructor(
		/** No WebAssembly; no worker; the core could not be fetched; what was fetched is no core. */
		readonly missing: "webassembly" | "worker" | "fetch" | "core",
		message: string,
		options?: ErrorOptions,
	) {
		super(message, options);
	}
}

/** A newer request took this one's place. Nothing to show: the newer one's result follows. */
export class Superseded extends Error {
	override name = "Superseded";
	constructor() {
		super("A newer request took this one's place.");
	}
}
