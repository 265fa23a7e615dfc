import type { Specimen } from "./specimen";

/**
 * A specimen piece by piece, less some of its parameters: what stands while a life runs through those.
 * @param keys of the parameters left out
 */
export function allBut({ parameters, ...fields }: Specimen, keys: readonly string[]): unknown[] {
	const values = Object.entries(parameters).map(([key, value]) => (keys.includes(key) ? undefined : value));
	return [...values, ...Object.entries(fields).flat()];
}
