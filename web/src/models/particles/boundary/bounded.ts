/** What a specimen of a tree or a root holds beyond its table: what bounds it, where it makes for, what stands in its way. */
import type { ClosedMesh } from "../../../specimen/closed_mesh";
import type { Specimen } from "../../../specimen/specimen";

/** A point of a profile that is turned about the upright axis: shares of half the boundary's width, and of its height from below. */
export type Knot = readonly [radius: number, height: number];

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
	/** The inner boundary, in place of the outer one made smaller; stretched to that one's box made as much smaller. No link carries it. */
	hollow?: ClosedMesh;
}

export type BoundedSpecimen = Specimen & Bounded;
