/**
 * Data by which shaders of games move a tree in wind: for each vertex the phase and the weight of its branch, the phase
 * of its leaf, the visible sky, and a pivot.
 */
import { hashFraction } from "../../plant/noise";
import type { Vector } from "../../plant/part";
import type { CardLevel } from "../cards/card_tree";
import type { Skeleton } from "../cards/skeleton";

/** The box that pivots are measured in, metres. */
export interface PivotBox {
	readonly low: Vector;
	readonly high: Vector;
}

export interface VertexWind {
	/** 4 × vertices: phase of the branch, weight of the branch, phase of the leaf, share of the sky. */
	readonly data: Uint8Array;
	/** 2 × vertices each: x and y, then z and 0 of the pivot, as shares of the box. */
	readonly pivots: readonly [Uint16Array, Uint16Array];
}

export interface LevelWind {
	readonly wood: VertexWind;
	readonly leaves: VertexWind;
}

/** Computes the wind data of a tree's levels. */
export class WindPainter {
	readonly #distances: Float32Array;
	readonly #farthest: number;

	/** @param sky the share of the sky that each segment sees, 0 … 1 */
	constructor(
		readonly skeleton: Skeleton,
		readonly box: PivotBox,
		readonly sky: (segment: number) => number,
	) {
		this.#distances = skeleton.distancesFromTrunk();
		this.#farthest = this.#distances.reduce((most, distance) => Math.max(most, distance), 1e-6);
	}

	/** Returns the data of a level. */
	level({ tubes, cards }: CardLevel): LevelWind {
		const wood = blank(tubes.segments.length);
		for (const [vertex, segment] of tubes.segments.entries()) {
			this.#write(wood, vertex, this.#branch(segment), 0, this.sky(segment), this.#base(segment));
		}
		const leaves = blank(cards.reduce((sum, { corners }) => sum + corners.length, 0));
		let vertex = 0;
		for (const { corners, anchor, segment, sky } of cards) {
			const branch = this.#branch(segment);
			const phase = hashFraction(Math.round(1000 * anchor[0]) ^ Math.round(77_000 * anchor[2]), 1000 * anchor[1]);
			for (let k = 0; k < corners.length; k++) this.#write(leaves, vertex++, branch, phase, sky, anchor);
		}
		return { wood, leaves };
	}

	/** Returns the phase of a segment's branch, and how far the segment bends. */
	#branch(segment: number): { phase: number; weight: number } {
		const phase = hashFraction(this.skeleton.branchOf(segment), 17);
		return { phase, weight: this.#distances[segment] / this.#farthest };
	}

	/** Returns the place at which a segment's branch leaves the trunk. */
	#base(segment: number): Vector {
		const { skeleton } = this;
		return skeleton.start(skeleton.stems[skeleton.branchOf(segment)].segments[0]);
	}

	/** Writes one vertex. */
	#write(
		{ data, pivots }: VertexWind,
		vertex: number,
		branch: { phase: number; weight: number },
		leaf: number,
		sky: number,
		pivot: Vector,
	): void {
		data.set(
			[branch.phase, branch.weight, leaf, sky].map((value) => Math.round(255 * value)),
			4 * vertex,
		);
		const { low, high } = this.box;
		const [x, y, z] = pivot.map((value, k) => {
			return Math.round((65_535 * Math.min(high[k] - low[k], Math.max(0, value - low[k]))) / (high[k] - low[k]));
		});
		pivots[0].set([x, y], 2 * vertex);
		pivots[1].set([z, 0], 2 * vertex);
	}
}

/** Returns data of vertices, to be written. */
const blank = (vertices: number): VertexWind => ({
	data: new Uint8Array(4 * vertices),
	pivots: [new Uint16Array(2 * vertices), new Uint16Array(2 * vertices)],
});
