/** What can go wrong on the way to a grown plant, by type. Every message is one plain sentence that can be shown. */

/** Reasons that the core gives, by code (wasm-core/src/foundation/result.hpp). */
export const CORE_REASONS = [
	"none",
	"bad request",
	"bad input",
	"syntax",
	"undefined name",
	"evaluation",
	"limit",
] as const;
export type CoreReason = (typeof CORE_REASONS)[number];

/** The core could not grow the request. Line and column count from 1 in the grammar's text; 0 where none is concerned. */
export class CoreError extends Error {
	override name = "CoreError";
	constructor(
		readonly reason: CoreReason,
		message: string,
		readonly line = 0,
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
