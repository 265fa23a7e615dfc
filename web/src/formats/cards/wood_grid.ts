/** Finds the wood nearest to a point. */
import type { Vector } from "../../plant/part";
import type { Skeleton } from "./skeleton";
import { between, lengthOf, subtract } from "./vectors";

/** Cells along the height of the wood in which segments are looked up. */
const CELLS = 48;
/** Cells along each axis that have numbers of their own. */
const SIDE = 1024;

export interface NearestWood {
	readonly segment: number;
	/** The nearest point of the segment's centre line, and its distance. */
	readonly place: Vector;
	readonly distance: number;
}

export class WoodGrid {
	readonly #cells = new Map<number, number[]>();
	readonly #size: number;

	/** @param retained whether each stem is looked up; absent: all are */
	constructor(
		readonly skeleton: Skeleton,
		retained?: Uint8Array,
	) {
		const { wood, height, stemOf } = skeleton;
		this.#size = Math.max(height / CELLS, 1e-3);
		for (let segment = 0; segment < wood.count; segment++) {
			if (retained && !retained[stemOf[segment]]) continue;
			const [start, end] = [skeleton.start(segment), skeleton.end(segment)];
			const steps = 1 + Math.ceil((2 * lengthOf(subtract(end, start))) / this.#size);
			let last = -1;
			for (let i = 0; i <= steps; i++) {
				const key = this.#key(between(start, end, i / steps));
				if (key === last) continue;
				last = key;
				const cell = this.#cells.get(key);
				if (cell) cell.push(segment);
				else this.#cells.set(key, [segment]);
			}
		}
	}

	/** Returns the nearest wood: among that in the cells around the point, in wider and wider cubes. */
	nearest(point: Vector): NearestWood {
		let [segment, least] = [-1, Number.POSITIVE_INFINITY];
		const middle = this.#key(point);
		for (let reach = 1; reach <= 2 * CELLS && segment < 0; reach *= 2) {
			for (let x = -reach; x <= reach; x++)
				for (let y = -reach; y <= reach; y++)
					for (let z = -reach; z <= reach; z++) {
						const cell = this.#cells.get(middle + (x * SIDE + y) * SIDE + z);
						if (!cell) continue;
						for (const each of cell) {
							const distance = this.#squaredDistance(each, point);
							if (distance < least) [segment, least] = [each, distance];
						}
					}
		}
		segment = Math.max(0, segment);
		const share = this.#nearestShare(segment, point[0], point[1], point[2]);
		const place = between(this.skeleton.start(segment), this.skeleton.end(segment), share);
		return { segment, place, distance: lengthOf(subtract(point, place)) };
	}

	/** Returns the nearest point of a segment's centre line, as a share of its length. */
	#nearestShare(segment: number, x: number, y: number, z: number): number {
		const { ends } = this.skeleton.wood;
		const at = 6 * segment;
		const [dx, dy, dz] = [ends[at + 3] - ends[at], ends[at + 4] - ends[at + 1], ends[at + 5] - ends[at + 2]];
		const along = (x - ends[at]) * dx + (y - ends[at + 1]) * dy + (z - ends[at + 2]) * dz;
		return Math.min(1, Math.max(0, along / Math.max(dx * dx + dy * dy + dz * dz, 1e-12)));
	}

	/** Returns the square of the distance between a point and the centre line of a segment. */
	#squaredDistance(segment: number, [x, y, z]: Vector): number {
		const { ends } = this.skeleton.wood;
		const share = this.#nearestShare(segment, x, y, z);
		const at = 6 * segment;
		const dx = ends[at] + share * (ends[at + 3] - ends[at]) - x;
		const dy = ends[at + 1] + share * (ends[at + 4] - ends[at + 1]) - y;
		const dz = ends[at + 2] + share * (ends[at + 5] - ends[at + 2]) - z;
		return dx * dx + dy * dy + dz * dz;
	}

	/** Returns the number of the cell that holds a point. */
	#key([x, y, z]: Vector): number {
		const cell = (value: number) => Math.floor(value / this.#size) + SIDE / 2;
		return (cell(x) * SIDE + cell(y)) * SIDE + cell(z);
	}
}
