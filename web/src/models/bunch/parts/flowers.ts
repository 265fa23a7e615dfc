/** Which berries still show their flower's stamens, and how large. */
import type { Berries } from "../grown";
import { traitOf } from "../traits";

/** Stamens smaller than this share of open ones are hidden in the bud, or have fallen. */
const LEAST = 0.01;

/**
 * The open flowers: two numbers each, the berry's index and how large its stamens stand to the radius of its ovary, 0 … 1.
 * They unfold as it opens and wither as it sets.
 */
export function openFlowers(berries: Berries): Float32Array {
	const open: number[] = [];
	for (let i = 0; i < berries.count; i++) {
		const out = traitOf(berries, i, "opened") * (1 - traitOf(berries, i, "set"));
		if (out > LEAST) open.push(i, out);
	}
	return Float32Array.from(open);
}
