import type { Colour } from "../../../plant/colour";
import { SphereIndex } from "../../../scene/sphere_index";
import type { Berries, Grown } from "../grown";
import type { BerryTint } from "../parts/berry_tint";
import { LEAST_LIGHT } from "../parts/skin_rules";
import { halvesOf, traitOf } from "../traits";
import { type Occluders, occludersOf } from "./occluders";

/** Spheres whose occlusion is evaluated per pixel; twelve is how many equal spheres can touch one. */
export const NEIGHBOURS = 12;
/** Where in a record the far occlusion stands; the neighbours follow it. */
export const FAR = 5;
/** Texels of one receiver's record; see `Receivers`. */
export const RECORD = FAR + 1 + NEIGHBOURS;

/** Farther than this many radii of the greatest berry, a sphere no longer counts towards the occlusion. */
const HORIZON = 9;
const MAX_FOUND = 1024;

/**
 * What receives light: berries first, then internodes. Each has a record of RECORD texels of four floats:
 *
 *     berry       0 centre, reach       1 direction, phase       2 log of ripe colour, bloom
 *                 3 log of unripe colour, turned                 4 half width, half length, shrivel, seeds
 *     internode   0 middle, half length 1 half axis, radius      2 state, kind; zeros up to 5
 *     all         5 far occlusion: constant, then the vector of its cosine part
 *                 6… the NEIGHBOURS spheres that hide most, relative to the centre, with radius; 0 ends the list
 */
export interface Receivers {
	/** Berries and internodes. */
	count: number;
	berries: number;
	records: Float32Array;
	/** The berries as spheres, for whoever casts shadows, and the berry each belongs to. */
	index: SphereIndex;
	owner: Uint32Array;
}

/** Texels the records of a bunch need. */
export function receiverTexels({ berries, internodes }: Grown): number {
	return (berries.count + internodes.count) * RECORD;
}

/** Finds out, for one receiver, what hides its sky. Holds the scratch memory of the search. */
class Surroundings {
	readonly #found = new Uint32Array(MAX_FOUND);
	readonly #weights = new Float64Array(NEIGHBOURS);
	readonly #nearest = new Int32Array(NEIGHBOURS);

	constructor(
		readonly index: SphereIndex,
		readonly owner: Uint32Array,
	) {}

	/**
	 * Fills texels FAR… of the record at `at` (in floats).
	 * @param self the berry that the receiver is, −1 for none
	 * @param extent radius of the receiver about its centre
	 */
	survey(records: Float32Array, at: number, self: number, extent: number): void {
		const { spheres, reach } = this.index;
		const [x, y, z] = [records[at], records[at + 1], records[at + 2]];
		const count = this.index.near(x, y, z, HORIZON * reach, this.#found);
		let kept = 0;
		for (let f = 0; f < count; f++) {
			const j = this.#found[f];
			if (this.owner[j] === self) continue;
			const dx = spheres[4 * j] - x;
			const dy = spheres[4 * j + 1] - y;
			const dz = spheres[4 * j + 2] - z;
			const r = spheres[4 * j + 3];
			// What a sphere hides goes with its apparent size seen from the receiver's surface.
			const gap = Math.max(Math.sqrt(dx * dx + dy * dy + dz * dz) - extent, 0.05 * r);
			kept = this.#keep(j, r / gap, kept);
		}
		this.#writeNear(records, at + 4 * (FAR + 1), kept, x, y, z);
		this.#writeFar(records, at + 4 * FAR, count, self, kept, x, y, z);
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
			if (this.owner[j] === self || this.#isNear(j, kept)) continue;
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
	const { spheres, owner }: Occluders = occludersOf(berries);
	const index = new SphereIndex(spheres);
	const around = new Surroundings(index, owner);
	const stride = 4 * RECORD;
	for (let i = 0; i < berries.count; i++) {
		packBerry(berries, i, tint(i), records, i * stride);
		around.survey(records, i * stride, i, berries.spheres[4 * i + 3]);
	}
	for (let i = 0; i < internodes.count; i++) {
		const at = (berries.count + i) * stride;
		const half = packInternode(grown, i, records, at);
		around.survey(records, at, -1, half);
	}
	return { count: berries.count + internodes.count, berries: berries.count, records, index, owner };
}

function packBerry(berries: Berries, i: number, tint: BerryTint, records: Float32Array, at: number): void {
	const halves = halvesOf(berries, i);
	records.set(berries.spheres.subarray(4 * i, 4 * i + 3), at);
	records[at + 3] = Math.max(...halves);
	records.set(berries.directions.subarray(3 * i, 3 * i + 3), at + 4);
	records[at + 7] = tint.phase;
	records.set(logarithmOf(tint.ripe), at + 8);
	records[at + 11] = tint.bloom;
	records.set(logarithmOf(tint.unripe), at + 12);
	records[at + 15] = traitOf(berries, i, "turned");
	records.set(halves, at + 16);
	records[at + 18] = traitOf(berries, i, "shrivel");
	records[at + 19] = traitOf(berries, i, "seeds");
}

/** Pigment absorbs, so a turning skin's colours mix as their logarithms do. */
function logarithmOf(colour: Colour): Colour {
	return colour.map((value) => Math.log(value + LEAST_LIGHT)) as Colour;
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
	records.fill(0, at + 10, at + 4 * FAR);
	return records[at + 3];
}
