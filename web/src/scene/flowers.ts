import type { Berries } from "../models/bunch/grown";
import { traitOf } from "./traits";

/** The open flowers: berry and how far its stamens stand out, 0 … 1; two numbers each. They wither as the berry sets. */
export function openFlowers(berries: Berries): Float32Array {
	const open: number[] = [];
	for (let i = 0; i < berries.count; i++) {
		const out = traitOf(berries, i, "opened") * (1 - traitOf(berries, i, "set"));
		if (out > 0.01) open.push(i, out);
	}
	return Float32Array.from(open);
}
