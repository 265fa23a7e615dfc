import type { SceneVector } from "../../../render/model_renderer";
import { lampHidden } from "../../../render/occlusion";
import { SphereIndex } from "../../../render/sphere_index";
import type { Receivers } from "./receivers";

/** Spheres between a receiver and the key light that the shader tests individually, at each vertex. */
export const CASTERS = 9;
/** Texels of one receiver's record; see `Casters.cast`. */
export const CAST_RECORD = 1 + CASTERS;

/** The most spheres that are tested for one receiver. */
const MAX_FOUND = 512;

/** A light: the direction towards it (unit length, in the bunch's frame) and the tangent of its apparent radius. */
export interface Lamp {
	direction: SceneVector;
	spread: number;
}

/**
 * Finds occluders. Occluders of a receiver lie in one column of light, so the spheres are sorted in the plane across
 * the light's direction and only the column is searched.
 */
export class Casters {
	/** Spheres in the column of the current receiver. */
	readonly #candidates = new Uint32Array(MAX_FOUND);
	/** The nearest casters of the current receiver, and their distances along the light. */
	readonly #nearest = new Int32Array(CASTERS);
	readonly #distances = new Float64Array(CASTERS);
	/** Buffer for the projected spheres of a `Column`. */
	#projected = new Float32Array(0);
	/** Inputs from which the records' shares of key and rim light were computed. */
	readonly #computedFor: (RecordInputs | undefined)[] = [];

	/**
	 * Fills the dynamic records, CAST_RECORD texels of four floats each, in the order of the receivers:
	 *
	 *     0   share of the key and of the rim light that reaches the receiver's centre
	 *     1…  the nearest spheres in the key light's way, centre and radius; 0 ends the list
	 *
	 * Results for the same receivers and lights are reused, in the same `records`: only rotation costs time.
	 * @returns whether anything was written
	 */
	cast(receivers: Receivers, key: Lamp, rim: Lamp, records: Float32Array): boolean {
		// Both must run.
		const rimWritten = this.#refresh(receivers, rim, records, 1);
		return this.#refresh(receivers, key, records, 0) || rimWritten;
	}

	/**
	 * Computes the shares of one lamp unless the records already have them; returns whether it wrote anything.
	 * @param channel 0 for the key lamp, 1 for the rim lamp
	 */
	#refresh(receivers: Receivers, lamp: Lamp, records: Float32Array, channel: 0 | 1): boolean {
		const before = this.#computedFor[channel];
		if (before?.receivers === receivers && isSameLamp(before.lamp, lamp)) return false;
		this.#computeShares(receivers, lamp, records, channel, channel === 0);
		this.#computedFor[channel] = { receivers, lamp };
		return true;
	}

	/**
	 * Writes the share of a lamp that reaches each receiver's centre, as a product over the spheres in between.
	 * @param channel 0 for the key lamp, 1 for the rim lamp
	 * @param writesCasters whether to write the nearest casters, too, which the shader tests individually
	 */
	#computeShares(
		receivers: Receivers,
		lamp: Lamp,
		records: Float32Array,
		channel: 0 | 1,
		writesCasters: boolean,
	): void {
		const { spheres } = receivers.index;
		const { owner } = receivers;
		const column = new Column(spheres, lamp.direction, this.#projectionBuffer(spheres.length));
		for (let i = 0; i < receivers.count; i++) {
			const to = i * 4 * CAST_RECORD;
			const [x, y, z, extent] = receivers.bodies.subarray(4 * i, 4 * i + 4);
			const count = column.near(x, y, z, extent, lamp.spread, this.#candidates);
			let share = 1;
			let listed = 0;
			for (let f = 0; f < count; f++) {
				const j = this.#candidates[f];
				if (owner[j] === i) continue;
				// Distance from the receiver to the sphere towards the lamp, and across that direction.
				const along = column.along(j, x, y, z);
				const radius = spheres[4 * j + 3];
				if (along <= -radius) continue;
				const lateral = column.lateral(j);
				share *= 1 - lampHidden(radius, lateral, along, lamp.spread);
				if (writesCasters && lateral < radius + extent + Math.max(along, 0) * lamp.spread)
					listed = this.#insert(j, along, listed);
			}
			records[to + channel] = share;
			if (writesCasters) this.#writeCasters(records, to + 4, listed, spheres);
		}
	}

	/**
	 * Inserts sphere `j` into the list of the nearest casters, sorted by distance; returns the list's new length.
	 * @param listed length of the list
	 */
	#insert(j: number, distance: number, listed: number): number {
		const distances = this.#distances;
		if (listed === CASTERS && distance >= distances[listed - 1]) return listed;
		let k = Math.min(listed, CASTERS - 1);
		for (; k > 0 && distances[k - 1] > distance; k--) {
			distances[k] = distances[k - 1];
			this.#nearest[k] = this.#nearest[k - 1];
		}
		distances[k] = distance;
		this.#nearest[k] = j;
		return Math.min(listed + 1, CASTERS);
	}

	/**
	 * Writes the list of the nearest casters into a record; a radius of 0 marks unused places.
	 * @param at index in `records` of the first caster
	 * @param listed number of casters
	 */
	#writeCasters(records: Float32Array, at: number, listed: number, spheres: Float32Array): void {
		for (let k = 0; k < CASTERS; k++) {
			const to = at + 4 * k;
			records[to + 3] = 0;
			if (k >= listed) continue;
			const from = 4 * this.#nearest[k];
			records.set(spheres.subarray(from, from + 4), to);
		}
	}

	/** Returns a buffer of that length, which is reused. */
	#projectionBuffer(length: number): Float32Array {
		if (this.#projected.length < length) this.#projected = new Float32Array(length);
		return this.#projected.subarray(0, length);
	}
}

interface RecordInputs {
	receivers: Receivers;
	lamp: Lamp;
}

/** Returns whether two lamps have the same direction and spread. */
function isSameLamp(one: Lamp, other: Lamp): boolean {
	return one.spread === other.spread && one.direction.every((value, k) => value === other.direction[k]);
}

/** The spheres in coordinates of one direction: two across it, one along. */
class Column {
	readonly #index: SphereIndex;
	readonly #u: SceneVector;
	readonly #v: SceneVector;
	#atU = 0;
	#atV = 0;

	/**
	 * Projects spheres on the plane across the light's direction.
	 * @param spheres 4 × count: centre x y z, radius
	 * @param direction unit vector to the light
	 * @param across receives the projections, in the same layout with z = 0
	 */
	constructor(
		readonly spheres: Float32Array,
		readonly direction: SceneVector,
		readonly across: Float32Array,
	) {
		const [x, y, z] = direction;
		// Duff et al. 2017, "Building an orthonormal basis, revisited".
		const sign = z >= 0 ? 1 : -1;
		const a = -1 / (sign + z);
		this.#u = [1 + sign * x * x * a, sign * x * y * a, -sign * x];
		this.#v = [x * y * a, sign + y * y * a, -y];
		for (let i = 0; i < spheres.length; i += 4) {
			across[i] = dot(this.#u, spheres[i], spheres[i + 1], spheres[i + 2]);
			across[i + 1] = dot(this.#v, spheres[i], spheres[i + 1], spheres[i + 2]);
			across[i + 2] = 0;
			across[i + 3] = spheres[i + 3];
		}
		this.#index = new SphereIndex(across);
	}

	/**
	 * Finds spheres that may occlude a receiver at x, y, z and returns their number; stores the receiver's position for
	 * `lateral`.
	 * @param extent radius of the receiver
	 * @param spread tangent of the lamp's apparent radius
	 * @param found receives the spheres' indices
	 */
	near(x: number, y: number, z: number, extent: number, spread: number, found: Uint32Array): number {
		this.#atU = dot(this.#u, x, y, z);
		this.#atV = dot(this.#v, x, y, z);
		const { reach } = this.#index;
		// Penumbrae widen with distance; beyond about eight berries (16 radii) little is hidden.
		return this.#index.near(this.#atU, this.#atV, 0, extent + reach * (1 + 16 * spread), found);
	}

	/** Returns the distance of sphere `j` from a point towards the light; negative behind the point. */
	along(j: number, x: number, y: number, z: number): number {
		const s = this.spheres;
		return dot(this.direction, s[4 * j] - x, s[4 * j + 1] - y, s[4 * j + 2] - z);
	}

	/** Returns the distance of sphere `j` from the receiver of the last `near`, across the light's direction. */
	lateral(j: number): number {
		const du = this.across[4 * j] - this.#atU;
		const dv = this.across[4 * j + 1] - this.#atV;
		return Math.sqrt(du * du + dv * dv);
	}
}

/** Returns the dot product of a direction and a vector. */
function dot(d: SceneVector, x: number, y: number, z: number): number {
	return d[0] * x + d[1] * y + d[2] * z;
}
