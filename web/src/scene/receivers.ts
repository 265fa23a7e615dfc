import type { Grown } from "../core/grown";
import type { BerryTint } from "./skin";
import { SphereIndex } from "./sphere_index";

/** Spheres whose occlusion is evaluated per pixel; twelve is how many equal spheres can touch one. */
export const NEIGHBOURS = 12;
/** Texels of one receiver's record; see `packReceivers`. */
export const RECORD = 4 + NEIGHBOURS;

/** Farther than this many radii of the greatest berry, a sphere no longer counts towards the occlusion. */
const HORIZON = 9;
const MAX_FOUND = 1024;

/**
 * What receives light: berries first, then internodes. Each has a record of RECORD texels of four floats:
 *
 *     berry       0 centre, radius      1 direction, phase       2 colour (linear), bloom
 *     internode   0 middle, half length 1 half axis, radius      2 state, kind, 0, 0
 *     both        3 far occlusion: constant, then the vector of its cosine part
 *                 4… the NEIGHBOURS spheres that hide most, relative to the centre, with radius; 0 ends the list
 */
export interface Receivers {
	/** Berries, then internodes. */
	count: number;
	berries: number;
	records: Float32Array;
	/** The index of the berries, for whoever casts shadows. */
	index: SphereIndex;
}

/** Texels the records of a bunch need. */
export function receiverTexels(grown: Grown): number {
	return (grown.berries.count + grown.internodes.count) * RECORD;
}

/** Finds out, for one receiver, what hides its sky. Holds the scratch memory of the search. */
class Surroundings {
	readonly #found = new Uint32Array(MAX_FOUND);
	readonly #weights = new Float64Array(NEIGHBOURS);
	readonly #nearest = new Int32Array(NEIGHBOURS);

	constructor(readonly index: SphereIndex) {}

	/**
	 * Fills texels 3… of the record at `at` (in floats).
	 * @param self index of the receiver's own sphere, −1 for none
	 * @param extent radius of the receiver about its centre
	 */
	survey(records: Float32Array, at: number, self: number, extent: number): void {
		const { spheres, reach } = this.index;
		const [x, y, z] = [records[at], records[at + 1], records[at + 2]];
		const count = this.index.near(x, y, z, HORIZON * reach, this.#found);
		let kept = 0;
		for (let f = 0; f < count; f++) {
			const j = this.#found[f];
			if (j === self) continue;
			const dx = spheres[4 * j] - x;
			const dy = spheres[4 * j + 1] - y;
			const dz = spheres[4 * j + 2] - z;
			const r = spheres[4 * j + 3];
			// What a sphere hides goes with its apparent size seen from the receiver's surface.
			const gap = Math.max(Math.sqrt(dx * dx + dy * dy + dz * dz) - extent, 0.05 * r);
			kept = this.#keep(j, r / gap, kept);
		}
		this.#writeNear(records, at + 16, kept, x, y, z);
		this.#writeFar(records, at + 12, count, self, kept, x, y, z);
	}

	/** Insertion into the short list, greatest weight first. */
	#keep(j: number, weight: number, kept: number): number {
		const weights = this.#weights;
		if (kept === NEIGHBOURS && weight <= weights[kept - 1]) return kept;
		let k = Math.min(kept, NEIGHBOURS - 1);
		for (; k > 0 && weights[k - 1] < weight; k--) {
			weights[k] = weights[k - 1];
			this.#nearest[k] = this.#nearest[k - 1];
		}
		weights[k] = weight;
		this.#nearest[k] = j;
		return Math.min(kept + 1, NEIGHBOURS);
	}

	#writeNear(records: Float32Array, at: number, kept: number, x: number, y: number, z: number): void {
		const { spheres } = this.index;
		for (let k = 0; k < NEIGHBOURS; k++) {
			const to = at + 4 * k;
			if (k >= kept) {
				records[to + 3] = 0;
				continue;
			}
			const j = 4 * this.#nearest[k];
			records[to] = spheres[j] - x;
			records[to + 1] = spheres[j + 1] - y;
			records[to + 2] = spheres[j + 2] - z;
			records[to + 3] = spheres[j + 3];
		}
	}

	/** The rest, as the first two bands of Σ sin²α · max(0, cos γ): 1/4 + cos γ / 2 (Ramamoorthi & Hanrahan 2001). */
	#writeFar(
		records: Float32Array,
		at: number,
		count: number,
		self: number,
		kept: number,
		x: number,
		y: number,
		z: number,
	) {
		const { spheres } = this.index;
		let [constant, ax, ay, az] = [0, 0, 0, 0];
		for (let f = 0; f < count; f++) {
			const j = this.#found[f];
			if (j === self || this.#isNear(j, kept)) continue;
			const dx = spheres[4 * j] - x;
			const dy = spheres[4 * j + 1] - y;
			const dz = spheres[4 * j + 2] - z;
			const r = spheres[4 * j + 3];
			const square = Math.max(dx * dx + dy * dy + dz * dz, r * r);
			const hidden = (r * r) / square;
			const unit = (0.5 * hidden) / Math.sqrt(square);
			constant += 0.25 * hidden;
			ax += unit * dx;
			ay += unit * dy;
			az += unit * dz;
		}
		records[at] = constant;
		records[at + 1] = ax;
		records[at + 2] = ay;
		records[at + 3] = az;
	}

	#isNear(j: number, kept: number): boolean {
		for (let k = 0; k < kept; k++) if (this.#nearest[k] === j) return true;
		return false;
	}
}

/** Writes the records of a bunch into `records` (at least `receiverTexels` × 4 floats), reusing its memory. */
export function packReceivers(grown: Grown, tint: (berry: number) => BerryTint, records: Float32Array): Receivers {
	const { berries, internodes } = grown;
	const index = new SphereIndex(berries.spheres.subarray(0, 4 * berries.count));
	const around = new Surroundings(index);
	const stride = 4 * RECORD;
	for (let i = 0; i < berries.count; i++) {
		const at = i * stride;
		records.set(berries.spheres.subarray(4 * i, 4 * i + 4), at);
		records.set(berries.directions.subarray(3 * i, 3 * i + 3), at + 4);
		// A berry keeps its tint with its pedicel: the pedicel's place in the list is steadier than the berry's own.
		const { colour, bloom, phase } = tint(berries.parent[i] ?? i);
		records[at + 7] = phase;
		records.set(colour, at + 8);
		records[at + 11] = bloom;
		around.survey(records, at, i, berries.spheres[4 * i + 3]);
	}
	for (let i = 0; i < internodes.count; i++) {
		const at = (berries.count + i) * stride;
		const half = packInternode(grown, i, records, at);
		around.survey(records, at, -1, half);
	}
	return { count: berries.count + internodes.count, berries: berries.count, records, index };
}

function packInternode({ internodes }: Grown, i: number, records: Float32Array, at: number): number {
	const { ends, radii, state, kind } = internodes;
	let square = 0;
	for (let k = 0; k < 3; k++) {
		const half = 0.5 * (ends[6 * i + 3 + k] - ends[6 * i + k]);
		records[at + k] = ends[6 * i + k] + half;
		records[at + 4 + k] = half;
		square += half * half;
	}
	records[at + 3] = Math.sqrt(square);
	records[at + 7] = 0.5 * (radii[2 * i] + radii[2 * i + 1]);
	records[at + 8] = state[i];
	records[at + 9] = kind[i];
	records[at + 10] = 0;
	records[at + 11] = 0;
	return records[at + 3];
}
