import { SphereIndex } from "../../../render/sphere_index";
import type { Berries, BunchPlant } from "../bunch_plant";
import { halvesOf } from "../traits";

/** Ratios of length to width from which on two, and three, spheres represent a berry. */
const TWO_SPHERES = 1.35;
const THREE_SPHERES = 2.1;
/** Positions of two or three spheres along a berry: 1 where a sphere of the berry's width would touch its end. */
const ROWS = { two: [-0.9, 0.9], three: [-1, 0, 1] } as const;
/** Radius of these spheres as a share of the berry's half width. */
const ROW_RADIUS = 0.96;

/** Receivers of light: berries first, then internodes; and the occluders, the berries. */
export interface Receivers {
	/** Number of berries and internodes. */
	count: number;
	/** 4 × count: centre, and reach from it. */
	bodies: Float32Array;
	/** Spheres of the berries: one for a round berry, a row of them for a long one. */
	index: SphereIndex;
	/** Berry of each sphere. */
	owner: Uint32Array;
}

/** Lists the receivers of berries' shadows: berries, then internodes, each with a sphere around it. */
export function receiversOf({ berries, internodes }: Pick<BunchPlant, "berries" | "internodes">): Receivers {
	const count = berries.count + internodes.count;
	const bodies = new Float32Array(4 * count);
	for (let i = 0; i < berries.count; i++) {
		bodies.set(berries.spheres.subarray(4 * i, 4 * i + 3), 4 * i);
		bodies[4 * i + 3] = Math.max(...halvesOf(berries, i));
	}
	for (let i = 0; i < internodes.count; i++) {
		const at = 4 * (berries.count + i);
		let square = 0;
		for (let k = 0; k < 3; k++) {
			const half = 0.5 * (internodes.ends[6 * i + 3 + k] - internodes.ends[6 * i + k]);
			bodies[at + k] = internodes.ends[6 * i + k] + half;
			square += half * half;
		}
		bodies[at + 3] = Math.sqrt(square);
	}
	const { spheres, owner } = occludersOf(berries);
	return { count, bodies, index: new SphereIndex(spheres), owner };
}

/** Returns the spheres that represent the berries as occluders. */
function occludersOf(berries: Berries): { spheres: Float32Array; owner: Uint32Array } {
	const spheres: number[] = [];
	const owner: number[] = [];
	for (let i = 0; i < berries.count; i++) {
		const [x, y, z, r] = berries.spheres.subarray(4 * i, 4 * i + 4);
		const [halfWidth, halfLength] = halvesOf(berries, i);
		const ratio = halfLength / halfWidth;
		if (!(ratio >= TWO_SPHERES)) {
			spheres.push(x, y, z, r);
			owner.push(i);
			continue;
		}
		for (const position of ratio < THREE_SPHERES ? ROWS.two : ROWS.three) {
			const offset = position * (halfLength - halfWidth);
			const [dx, dy, dz] = berries.directions.subarray(3 * i, 3 * i + 3);
			spheres.push(x + offset * dx, y + offset * dy, z + offset * dz, ROW_RADIUS * halfWidth);
			owner.push(i);
		}
	}
	return { spheres: Float32Array.from(spheres), owner: Uint32Array.from(owner) };
}
