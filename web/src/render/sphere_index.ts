/**
 * Uniform grid of spheres, for finding the spheres near a point. Built for each plant from its `4 × count` array
 * (centre x y z, radius), which is not copied.
 */
export class SphereIndex {
	readonly count: number;
	/** Greatest radius; 0 without spheres. */
	readonly reach: number;
	readonly #low = [0, 0, 0];
	readonly #cells = [1, 1, 1];
	readonly #size: number;
	/** Index in `#order` at which each cell begins; one more entry than cells. */
	readonly #starts: Uint32Array;
	readonly #order: Uint32Array;

	/** @param spheres 4 × count: centre x y z, radius, in metres; not copied */
	constructor(readonly spheres: Float32Array) {
		this.count = Math.floor(spheres.length / 4);
		const low = [Infinity, Infinity, Infinity];
		const high = [-Infinity, -Infinity, -Infinity];
		let reach = 0;
		for (let i = 0; i < this.count; i++) {
			for (let k = 0; k < 3; k++) {
				low[k] = Math.min(low[k], spheres[4 * i + k]);
				high[k] = Math.max(high[k], spheres[4 * i + k]);
			}
			reach = Math.max(reach, spheres[4 * i + 3]);
		}
		this.reach = reach;
		this.#size = Math.max(2 * reach, 1e-6);
		if (this.count > 0) {
			for (let k = 0; k < 3; k++) {
				this.#low[k] = low[k];
				this.#cells[k] = Math.min(64, Math.floor((high[k] - low[k]) / this.#size) + 1);
			}
		}
		this.#starts = new Uint32Array(this.#cells[0] * this.#cells[1] * this.#cells[2] + 1);
		this.#order = new Uint32Array(this.count);
		this.#sort();
	}

	/** Returns the cell of a coordinate along one axis (0 … 2), limited to the grid. */
	#cellAlong(axis: number, value: number): number {
		const cell = Math.floor((value - this.#low[axis]) / this.#size);
		return Math.min(this.#cells[axis] - 1, Math.max(0, cell));
	}

	/** Returns the number of the cell in which the centre of sphere `i` is: x fastest, z slowest. */
	#cellOf(i: number): number {
		const s = this.spheres;
		const x = this.#cellAlong(0, s[4 * i]);
		const y = this.#cellAlong(1, s[4 * i + 1]);
		const z = this.#cellAlong(2, s[4 * i + 2]);
		return x + this.#cells[0] * (y + this.#cells[1] * z);
	}

	/** Fills `#starts` and `#order` by a counting sort: two passes, no lists. */
	#sort(): void {
		for (let i = 0; i < this.count; i++) this.#starts[this.#cellOf(i) + 1]++;
		for (let c = 1; c < this.#starts.length; c++) this.#starts[c] += this.#starts[c - 1];
		const next = this.#starts.slice();
		for (let i = 0; i < this.count; i++) this.#order[next[this.#cellOf(i)]++] = i;
	}

	/**
	 * Writes the indices of spheres whose centres may be within `distance` of the point into `found`, at most as many as
	 * it has room for.
	 * @returns their number
	 */
	near(x: number, y: number, z: number, distance: number, found: Uint32Array): number {
		const [nx, ny] = this.#cells;
		const fromX = this.#cellAlong(0, x - distance);
		const toX = this.#cellAlong(0, x + distance);
		const toY = this.#cellAlong(1, y + distance);
		const toZ = this.#cellAlong(2, z + distance);
		let count = 0;
		for (let cz = this.#cellAlong(2, z - distance); cz <= toZ; cz++) {
			for (let cy = this.#cellAlong(1, y - distance); cy <= toY; cy++) {
				const row = nx * (cy + ny * cz);
				const end = this.#starts[row + toX + 1];
				for (let at = this.#starts[row + fromX]; at < end && count < found.length; at++)
					found[count++] = this.#order[at];
			}
		}
		return count;
	}
}
