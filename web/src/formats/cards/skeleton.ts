/**
 * The wood of a plant as stems: chains of segments from base to tip, each of which begins on another stem. Trees with
 * fewer triangles leave out thin stems, so every stem that is left still begins on wood.
 */
import type { Vector } from "../../plant/part";
import type { Segments } from "../../plant/plant";
import { dot, lengthOf, subtract } from "./vectors";

/** Consecutive segments, from base to tip. */
export interface Stem {
	/** Index of the stem that it begins on, −1 for a trunk. */
	readonly parent: number;
	/** The segment that it begins on, −1 for a trunk. */
	readonly parentSegment: number;
	readonly segments: readonly number[];
	/** Radius at the base, at most that of its parent: stems are left out in the order of this number. */
	readonly radius: number;
	/** The number of stems between it and the trunk. */
	readonly order: number;
}

/** A point on the centre line of a stem. */
export interface StemPoint {
	readonly place: Vector;
	readonly radius: number;
	/** Distance from the base of the stem, metres. */
	readonly distance: number;
	/** The segment that ends here; at the base, the first segment. */
	readonly segment: number;
}

export class Skeleton {
	/** Parents come before their children. */
	readonly stems: readonly Stem[];
	/** The stem of each segment. */
	readonly stemOf: Int32Array;
	/** For each segment, its number in a walk of the tree that finishes one branch before it begins the next. */
	readonly walk: Int32Array;
	/** The height and the largest radius of the wood. */
	readonly height: number;
	readonly thickest: number;

	constructor(readonly wood: Segments) {
		const { count, parent, ends, radii } = wood;
		const children: number[][] = Array.from({ length: count }, () => []);
		const roots: number[] = [];
		for (let i = 0; i < count; i++) (parent[i] < 0 ? roots : children[parent[i]]).push(i);
		this.stemOf = new Int32Array(count).fill(-1);
		this.walk = new Int32Array(count);
		const stems: Stem[] = [];
		// A stack of stems to follow: the first segment of each. The last one added is followed first.
		const open = roots.reverse().map((first) => ({ first, parent: -1 }));
		let step = 0;
		for (let next = open.pop(); next; next = open.pop()) {
			const number = stems.length;
			const segments: number[] = [];
			for (let at: number | undefined = next.first; at !== undefined; ) {
				segments.push(at);
				this.stemOf[at] = number;
				this.walk[at] = step++;
				const [main, ...others]: number[] = children[at].toSorted((a, b) => radii[2 * b] - radii[2 * a] || a - b);
				for (const other of others) open.push({ first: other, parent: at });
				at = main;
			}
			const above = next.parent < 0 ? undefined : stems[this.stemOf[next.parent]];
			const radius = radii[2 * next.first];
			stems.push({
				parent: above ? this.stemOf[next.parent] : -1,
				parentSegment: next.parent,
				segments,
				radius: above ? Math.min(radius, above.radius) : radius,
				order: above ? above.order + 1 : 0,
			});
		}
		this.stems = stems;
		let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
		for (let i = 1; i < ends.length; i += 3) [low, high] = [Math.min(low, ends[i]), Math.max(high, ends[i])];
		this.height = count > 0 ? high - low : 0;
		this.thickest = stems.reduce((most, { radius }) => Math.max(most, radius), 0);
	}

	/** Returns the branch that leaves a trunk and carries a segment: the number of its stem, or of the trunk. */
	branchOf(segment: number): number {
		let stem = this.stemOf[segment];
		while (this.stems[stem].order > 1) stem = this.stems[stem].parent;
		return stem;
	}

	/** Returns the distance of each segment's end from the trunk, along the wood, metres. */
	distancesFromTrunk(): Float32Array {
		const distances = new Float32Array(this.wood.count);
		for (const { order, parentSegment, segments } of this.stems) {
			if (order === 0) continue;
			let distance = distances[parentSegment];
			for (const segment of segments) {
				distance += lengthOf(subtract(this.end(segment), this.start(segment)));
				distances[segment] = distance;
			}
		}
		return distances;
	}

	/** Returns where a segment starts. */
	start(segment: number): Vector {
		const { ends } = this.wood;
		return [ends[6 * segment], ends[6 * segment + 1], ends[6 * segment + 2]];
	}

	/** Returns where a segment ends. */
	end(segment: number): Vector {
		const { ends } = this.wood;
		return [ends[6 * segment + 3], ends[6 * segment + 4], ends[6 * segment + 5]];
	}

	/** Returns the centre line of a stem, without points within `tolerance` metres of the line between their neighbours. */
	line({ segments }: Stem, tolerance: number): StemPoint[] {
		const { radii } = this.wood;
		const all: StemPoint[] = [
			{ place: this.start(segments[0]), radius: radii[2 * segments[0]], distance: 0, segment: segments[0] },
		];
		for (const segment of segments) {
			const last = all[all.length - 1];
			const place = this.end(segment);
			const distance = last.distance + lengthOf(subtract(place, last.place));
			all.push({ place, radius: radii[2 * segment + 1], distance, segment });
		}
		const points = [all[0]];
		let last = 0;
		for (let end = 2; end < all.length; end++) {
			if (isStraight(all, last, end, tolerance)) continue;
			last = end - 1;
			points.push(all[last]);
		}
		points.push(all[all.length - 1]);
		return points;
	}
}

/** Returns whether all points between two of a line are within a tolerance of the straight line and of its radii. */
function isStraight(points: readonly StemPoint[], from: number, to: number, tolerance: number): boolean {
	const start = points[from];
	const line = subtract(points[to].place, start.place);
	const squared = Math.max(dot(line, line), 1e-12);
	for (let i = from + 1; i < to; i++) {
		const away = subtract(points[i].place, start.place);
		const share = dot(away, line) / squared;
		const offSquared = dot(away, away) - share * share * squared;
		if (offSquared > tolerance * tolerance) return false;
		const radius = start.radius + share * (points[to].radius - start.radius);
		if (Math.abs(radius - points[i].radius) > 0.5 * tolerance + 0.1 * radius) return false;
	}
	return true;
}
