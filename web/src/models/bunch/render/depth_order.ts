/** Draw order: nearest first, so that the depth test skips the pixels of those behind. */
export class DepthOrder {
	#spheres: Float32Array = new Float32Array(0);
	#depths = new Float64Array(0);
	#indices: number[] = [];
	/** Position of the eye for which the indices are sorted. */
	#sortedFrom: readonly number[] | undefined;

	/**
	 * Sets the spheres to order. If their number is unchanged, the previous order is the start, since little changes
	 * from frame to frame.
	 * @param spheres 4 × count: centre, radius
	 */
	reset(spheres: Float32Array): void {
		this.#spheres = spheres;
		this.#sortedFrom = undefined;
		const count = spheres.length / 4;
		if (count === this.#indices.length) return;
		this.#depths = new Float64Array(count);
		this.#indices = Array.from({ length: count }, (_, i) => i);
	}

	/** Indices in the order of the last `sort`; the same array until the next `reset`. */
	get indices(): readonly number[] {
		return this.#indices;
	}

	/** Sorts by the distance from `eye`; returns whether the eye has moved. */
	sort({ x, y, z }: { x: number; y: number; z: number }): boolean {
		const from = this.#sortedFrom;
		if (from && from[0] === x && from[1] === y && from[2] === z) return false;
		this.#sortedFrom = [x, y, z];
		const spheres = this.#spheres;
		for (const i of this.#indices) {
			const at = 4 * i;
			this.#depths[i] = (spheres[at] - x) ** 2 + (spheres[at + 1] - y) ** 2 + (spheres[at + 2] - z) ** 2;
		}
		this.#indices.sort((a, b) => this.#depths[a] - this.#depths[b]);
		return true;
	}
}
