import { noise } from "../../../plant/noise";
import type { Berries } from "../bunch_plant";
import { halvesOf } from "../traits";
import { COARSE, type Pattern } from "./skin_rules";

/** Berry space, in which a berry is the unit ball, and a current point in it. */
export class Ball {
	readonly #centre: Float32Array;
	readonly #axis: Float32Array;
	/** Half width, metres. */
	readonly #halfWidth: number;
	/** Half width by half length, less 1: added to the identity along the axis, it makes the berry round. */
	readonly #stretch: number;
	#x = 0;
	#y = 0;
	#z = 0;
	/** Position along the berry's axis: −1 at the seat … 1 at the tip. */
	along = 0;
	/** Distance from the centre. */
	height = 0;

	constructor(berries: Berries, index: number) {
		const [halfWidth, halfLength] = halvesOf(berries, index);
		this.#centre = berries.spheres.subarray(4 * index, 4 * index + 3);
		this.#axis = berries.directions.subarray(3 * index, 3 * index + 3);
		this.#halfWidth = halfWidth;
		this.#stretch = halfWidth / halfLength - 1;
	}

	/**
	 * Converts a point of the bunch to berry space and makes it the current point.
	 * @param at index of its x in `positions`
	 */
	enter(positions: ArrayLike<number>, at: number): void {
		const centre = this.#centre;
		const axis = this.#axis;
		const x = positions[at] - centre[0];
		const y = positions[at + 1] - centre[1];
		const z = positions[at + 2] - centre[2];
		const shift = (x * axis[0] + y * axis[1] + z * axis[2]) * this.#stretch;
		this.#x = (x + axis[0] * shift) / this.#halfWidth;
		this.#y = (y + axis[1] * shift) / this.#halfWidth;
		this.#z = (z + axis[2] * shift) / this.#halfWidth;
		this.along = this.#x * axis[0] + this.#y * axis[1] + this.#z * axis[2];
		this.height = Math.sqrt(this.#x * this.#x + this.#y * this.#y + this.#z * this.#z);
	}

	/** Returns the component of the point along a direction. */
	towards([x, y, z]: readonly [x: number, y: number, z: number]): number {
		return this.#x * x + this.#y * y + this.#z * z;
	}

	/** Returns the noise of a pattern at the point, for a berry of that phase. */
	noise(phase: number, pattern: Pattern = COARSE): number {
		const [x, y, z] = this.in(phase, pattern);
		return noise(x, y, z);
	}

	/**
	 * Returns the current point in the space of a pattern's noise.
	 * @param phase of the berry, which shifts the noise
	 */
	in(phase: number, { cells, phase: offsetPerPhase }: Pattern): [x: number, y: number, z: number] {
		const shift = phase * offsetPerPhase;
		return [this.#x * cells + shift, this.#y * cells + shift, this.#z * cells + shift];
	}
}
