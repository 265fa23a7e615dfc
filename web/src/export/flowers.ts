/** Which berries still show their flower's stamens, and how large. */
import type { Grown, Mesh } from "../models/bunch/grown";
import { traitOf } from "./traits";

/** Stamens smaller than this share of open ones are hidden in the bud, or have fallen. */
const LEAST = 0.05;

export interface Flowers {
	/** Stamens about an ovary of unit radius, facing +Y. */
	mesh: Mesh;
	/**
	 * Index of a berry, and how large its stamens stand to the radius of its ovary: they unfold as it opens and wither as
	 * it sets.
	 */
	shares: [index: number, share: number][];
}

/** Undefined where no flower is to be seen. */
export function flowerOf({ flower: mesh, berries }: Grown): Flowers | undefined {
	if (!mesh || mesh.indices.length === 0) return undefined;
	const all = Array.from({ length: berries.count }, (_, i): [number, number] => [
		i,
		traitOf(berries, i, "opened") * (1 - traitOf(berries, i, "set")),
	]);
	const shares = all.filter(([, share]) => share >= LEAST);
	return shares.length > 0 ? { mesh, shares } : undefined;
}
