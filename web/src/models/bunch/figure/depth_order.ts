/** The order in which things are drawn: nearest first, so that the depth test spares the pixels of those behind. */
export class DepthOrder {
	#depths = new Float64Array(0);
	#order: number[] = [];

	get count(): number {
		return this.#order.length;
	}

	/** Starts anew with so many things, unless there are as many already: from frame to frame little changes. */
	reset(count: number): void {
		if (count === this.#order.length) return;
		this.#depths = new Float64Array(count);
		this.#order = Array.from({ length: count }, (_, i) => i);
	}

	/**
	 * @param spheres 4 × count: centre, radius
	 * @returns indices, the nearest to the eye first; the same array every time
	 */
	sorted(spheres: Float32Array, eye: { x: number; y: number; z: number }): readonly number[] {
		for (let i = 0; i < this.#order.length; i++) {
			const at = 4 * i;
			this.#depths[i] = (spheres[at] - eye.x) ** 2 + (spheres[at + 1] - eye.y) ** 2 + (spheres[at + 2] - eye.z) ** 2;
		}
		return this.#order.sort((a, b) => this.#depths[a] - this.#depths[b]);
	}
}
