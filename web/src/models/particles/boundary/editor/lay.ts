/** How a model's numbers lay out its boundary, seen from in front. Metres; the ground is at height 0. */
import type { BoundedSpecimen, Knot } from "../bounded";
import { type Form, outlineOf } from "./outline";

type Parameters = Readonly<Partial<Record<string, number>>>;

/** The box that a boundary fills. */
export interface Box {
	readonly halfWidth: number;
	readonly low: number;
	readonly high: number;
}

export interface Lay<S extends BoundedSpecimen = BoundedSpecimen> {
	form(specimen: S): Form;
	/** The profile of a spline that the specimen does not say. */
	readonly profile: readonly Knot[];
	box(specimen: S): Box;
	/** Where the axes of its boundaries stand, from left to right. */
	axes(specimen: S): readonly number[];
	/** What is needed of the parameters for the box to be another. */
	fit(specimen: S, box: Box): Parameters;
	/** What is needed for the last axis to stand elsewhere; undefined where there is one. */
	move?(specimen: S, axis: number): Parameters | undefined;
	/** What the box's upper and lower end are called. */
	readonly ends: { readonly high: string; readonly low: string };
	/** The height about which the inner boundary is the outer one made smaller. */
	bareAbout(box: Box): number;
}

/** Of width that reaches out to one side, and of depth that was the same: round stays round. */
export function roundly({ parameters }: BoundedSpecimen, halfWidth: number): Parameters {
	const width = 2 * halfWidth;
	return parameters.depth === parameters.width ? { width, depth: width } : { width };
}

/** The outline of a specimen's boundary, in shares of its box. */
export function outlineIn<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): readonly Knot[] {
	return outlineOf(lay.form(specimen), specimen.profile ?? lay.profile, specimen.volume);
}
