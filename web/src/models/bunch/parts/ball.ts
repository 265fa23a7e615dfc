import { noise } from "../../../plant/noise";
import type { Berries } from "../bunch_plant";
import { halvesOf } from "../traits";
import { COARSE, type Pattern } from "./skin_rules";

/** Berry space, in which a berry is the unit ball, and a current point in it. */
export class Ball {
	readonly #centre: Float32Array;
	readonly #axis: Float32Array;
	readonly #width: number;
	readonly #stretch: number;
	#x = 0;
	#y = 0;
	#z = 0;
	/** Position along the berry's axis: −1 at the seat … 1 at the tip. */
	along = 0;
	/** Distance from the centre. */
	height = 0;

	constructor(berries: Berries, index: number) {
		const [width, length] = halvesOf(berries, index);
		this.#centre = berries.spheres.subarray(4 * index, 4 * index + 3);
		this.#axis = berries.directions.subarray(3 * index, 3 * index + 3);
		this.#width = width;
		this.#stretch = width / length - 1;
	}

	/** Moves to the point whose x, y and z start at index `at`. */
	enter(positions: ArrayLike<number>, at: number): void {
		const centre = this.#centre;
		const axis = this.#axis;
		const x = positions[at] - centre[0];
		const y = positions[at + 1] - centre[1];
		const z = positions[at + 2] - centre[2];
		const shift = (x * axis[0] + y * axis[1] + z * axis[2]) * this.#stretch;
		this.#x = (x + axis[0] * shift) / this.#width;
		this.#y = (y + axis[1] * shift) / this.#width;
		this.#z = (z + axis[2] * shift) / this.#width;
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

	/** Returns the point in the space of a pattern's noise. */
	in(phase: number, { cells, phase: apart }: Pattern): [x: number, y: number, z: number] {
		const shift = phase * apart;
		return [this.#x * cells + shift, this.#y * cells + shift, this.#z * cells + shift];
	}
}
