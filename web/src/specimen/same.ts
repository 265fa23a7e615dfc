import type { Specimen } from "./specimen";

/** Returns whether two specimens of any model are the same document, and so have the same link. */
export function sameSpecimen<S extends Specimen>(a: S, b: S): boolean {
	return alike(a, b);
}

/**
 * Returns whether two specimens surely grow the same plant; colours do not matter. Another preset may bring another
 * text.
 */
export function growsAlike<S extends Specimen>(a: S, b: S): boolean {
	return alike({ ...a, look: b.look }, b);
}

/** Returns whether two plain values are deeply equal; undefined counts as absent. */
function alike(a: unknown, b: unknown): boolean {
	if (Object.is(a, b)) return true;
	if (typeof a !== "object" || typeof b !== "object" || a === null || b === null) return false;
	if (Array.isArray(a) !== Array.isArray(b)) return false;
	const [one, other] = [a, b] as Readonly<Record<string, unknown>>[];
	return [...new Set([...Object.keys(one), ...Object.keys(other)])].every((key) => alike(one[key], other[key]));
}
