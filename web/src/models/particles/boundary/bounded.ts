/** Fields of a tree's or root's specimen beyond its table: boundary, targets and obstacles. */
import type { ClosedMesh } from "../../../specimen/closed_mesh";
import type { Specimen } from "../../../specimen/specimen";

/**
 * A point of a profile that is revolved about the vertical axis: radius as a share of half the boundary's width,
 * height as a share of the boundary's height, from below.
 */
export type Knot = readonly [radius: number, height: number];

export interface Bounded {
	/**
	 * The profile of the shape `spline`, from the lower to the upper end; where absent, the model's default profile.
	 */
	profile?: Knot[];
	/** Points that particles move to, metres: x, y, z of each. They replace the table's targets. */
	targets?: number[];
	/** Boxes without growth, metres: low x, y, z, high x, y, z of each. */
	obstacles?: number[];
	/**
	 * Ellipsoids without growth that cast shade, such as another tree's crown: their bounding boxes, as in
	 * `obstacles`.
	 */
	rounds?: number[];
	/** The boundary of the shape `mesh`. Links do not carry it. */
	volume?: ClosedMesh;
	/**
	 * A mesh for the inner boundary in place of the scaled outer one; it is stretched to the scaled box. Links do not
	 * carry it.
	 */
	hollow?: ClosedMesh;
}

export type BoundedSpecimen = Specimen & Bounded;
