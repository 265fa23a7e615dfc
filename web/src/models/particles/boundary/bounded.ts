/** What a specimen of a tree or a root holds beyond its table: what bounds it, where it makes for, what stands in its way. */
import type { Specimen } from "../../../specimen/specimen";

/** A point of a profile that is turned about the upright axis: shares of half the boundary's width, and of its height from below. */
export type Knot = readonly [radius: number, height: number];

/** A closed mesh of one's own; the boundary's width, height and depth stretch it. */
export interface ClosedMesh {
	/** 3 × points. */
	points: number[];
	/** 3 × triangles, counter-clockwise from outside. */
	triangles: number[];
}

export interface Bounded {
	/** Of the shape `spline`, from one end to the other; the built-in one where absent. */
	profile?: Knot[];
	/** Places that particles make for, metres: x, y, z; in place of those of the table where there are any. */
	targets?: number[];
	/** Boxes in which nothing grows, metres: low x, y, z, high x, y, z. */
	obstacles?: number[];
	/** Round ones, such as another tree's crown, behind which it is dark: the boxes that these ellipsoids fill, as above. */
	rounds?: number[];
	/** Of the shape `mesh`. No link carries it. */
	volume?: ClosedMesh;
}

export type BoundedSpecimen = Specimen & Bounded;
