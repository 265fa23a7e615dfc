import type { Specimen } from "./specimen";

/**
 * Returns the fields of a specimen without some of its parameters: the values that stay the same while a plant ages.
 * @param keys keys of the parameters left out
 */
export function allBut({ parameters, ...fields }: Specimen, keys: readonly string[]): unknown[] {
	const values = Object.entries(parameters).map(([key, value]) => (keys.includes(key) ? undefined : value));
	return [...values, ...Object.entries(fields).flat()];
}
