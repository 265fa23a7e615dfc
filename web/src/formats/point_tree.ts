/**
 * A k-d tree of points in space (Bentley 1975, "Multidimensional binary search trees used for associative searching").
 */
export class PointTree {
	readonly #points: Float32Array;
	/** Point indices: the middle of each range splits it along x, y or z in turn. */
	readonly #order: Uint32Array;
	#place: readonly [x: number, y: number, z: number] = [0, 0, 0];
	#found = 0;
	/** The square of the distance of the nearest point so far. */
	#least = 0;

	/** @param points 3 × points, at least one */
	constructor(points: Float32Array) {
		this.#points = points;
		this.#order = Uint32Array.from({ length: points.length / 3 }, (_, i) => i);
		this.#split(0, this.#order.length, 0);
	}

	/** Returns the index of the nearest point. */
	nearest(x: number, y: number, z: number): number {
		this.#place = [x, y, z];
		this.#least = Number.POSITIVE_INFINITY;
		this.#search(0, this.#order.length, 0);
		return this.#found;
	}

	/** Sorts the points `from` … `to` − 1 of the order into a tree whose root, in the middle, splits along `axis`. */
	#split(from: number, to: number, axis: number): void {
		if (to - from < 2) return;
		const middle = (from + to) >> 1;
		this.#select(middle, from, to, axis);
		this.#split(from, middle, (axis + 1) % 3);
		this.#split(middle + 1, to, (axis + 1) % 3);
	}

	/**
	 * Partially sorts the points `from` … `to` − 1 of the order by their coordinate along `axis`: afterwards, `middle` has
	 * the point that full sorting would place there, with no greater one before it and no lower one after it (Hoare's
	 * selection: partitions by a pivot, and repeats in the part that contains `middle`).
	 */
	#select(middle: number, from: number, to: number, axis: number): void {
		const [points, order] = [this.#points, this.#order];
		let [first, last] = [from, to - 1];
		while (first < last) {
			const pivot = points[3 * order[(first + last) >> 1] + axis];
			let [i, j] = [first, last];
			while (i <= j) {
				while (points[3 * order[i] + axis] < pivot) i++;
				while (points[3 * order[j] + axis] > pivot) j--;
				if (i > j) break;
				[order[i], order[j]] = [order[j], order[i]];
				i++;
				j--;
			}
			if (middle <= j) last = j;
			else if (middle >= i) first = i;
			else return;
		}
	}

	/**
	 * Searches the points `from` … `to` − 1 of the order, which are split along `axis`, for one nearer than `#least`: first
	 * on the side of the place, then on the other side if the splitting plane is near enough.
	 */
	#search(from: number, to: number, axis: number): void {
		if (from >= to) return;
		const middle = (from + to) >> 1;
		const [points, [x, y, z]] = [this.#points, this.#place];
		const at = 3 * this.#order[middle];
		const distance = (points[at] - x) ** 2 + (points[at + 1] - y) ** 2 + (points[at + 2] - z) ** 2;
		if (distance < this.#least) [this.#found, this.#least] = [this.#order[middle], distance];
		const beyond = this.#place[axis] - points[at + axis];
		const next = (axis + 1) % 3;
		if (beyond < 0) this.#search(from, middle, next);
		else this.#search(middle + 1, to, next);
		if (beyond ** 2 >= this.#least) return;
		if (beyond < 0) this.#search(middle + 1, to, next);
		else this.#search(from, middle, next);
	}
}
