import type { Berries } from "../grown";
import { halvesOf } from "../traits";

/** From these lengths over widths on, a berry stands in the light as two spheres, as three. */
const TWO = 1.35;
const THREE = 2.1;

/** The spheres that stand in the light for the berries: one for a round berry, a row of them for a long one. */
export interface Occluders {
	/** 4 × spheres: centre, radius. */
	spheres: Float32Array;
	/** The berry each sphere belongs to. */
	owner: Uint32Array;
}

export function occludersOf(berries: Berries): Occluders {
	const spheres: number[] = [];
	const owner: number[] = [];
	for (let i = 0; i < berries.count; i++) {
		const [x, y, z, r] = berries.spheres.subarray(4 * i, 4 * i + 4);
		const [width, length] = halvesOf(berries, i);
		const ratio = length / width;
		if (!(ratio >= TWO)) {
			spheres.push(x, y, z, r);
			owner.push(i);
			continue;
		}
		const reach = length - width;
		for (const along of ratio < THREE ? [-0.9, 0.9] : [-1, 0, 1]) {
			const by = along * reach;
			const [dx, dy, dz] = berries.directions.subarray(3 * i, 3 * i + 3);
			spheres.push(x + by * dx, y + by * dy, z + by * dz, 0.96 * width);
			owner.push(i);
		}
	}
	return { spheres: Float32Array.from(spheres), owner: Uint32Array.from(owner) };
}
