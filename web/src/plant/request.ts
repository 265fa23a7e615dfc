/** The blocks of a request that models share. */
import type { Block } from "../core/container";
import { CoreError } from "../core/errors";
import { text } from "./messages.generated";

/** The part of a specimen that every request contains. */
interface Requested {
	readonly model: string;
	readonly seed: number;
	readonly parameters: Readonly<Record<string, number>>;
}

/**
 * Returns the blocks with which a request begins: model, seed, outputs and parameters.
 * @param core the parameters that the core reads, in the order of its request
 * @param outputs names of the requested outputs; others are ignored
 * @throws CoreError where a parameter is not a number
 */
export function requestBlocks(
	{ model, seed, parameters }: Requested,
	core: readonly { readonly key: string }[],
	outputs: readonly (string | false | undefined)[],
): Block[] {
	return [
		{ name: "model", data: model },
		{ name: "seed", data: Uint32Array.of(seed) },
		{ name: "outputs", data: outputs.filter(Boolean).join(" ") },
		{ name: "parameters", data: Float32Array.from(core, ({ key }) => finiteNumber(key, parameters[key])) },
	];
}

/**
 * Returns the value of a parameter for a request.
 * @throws CoreError where it is not a finite number
 */
export function finiteNumber(key: string, value: number): number {
	if (Number.isFinite(value)) return value;
	throw new CoreError("bad request", text.message("not_a_number", { key }));
}

/**
 * Returns the text of a preset or a specimen.
 * @throws CoreError where the preset's text has not been fetched
 */
export function requireText(fetched: string | undefined): string {
	if (fetched !== undefined) return fetched;
	throw new CoreError("bad request", text.message("preset_text_missing"));
}

/** Returns the error of a grammar that is too long for the core. */
export const tooLong = (bytes: number): CoreError =>
	new CoreError("limit", text.message("grammar_too_long", { kib: bytes / 1024 }));
