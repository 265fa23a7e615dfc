/** How a model's numbers lay out its boundary, seen from in front. Metres; the ground is at height 0. */

import { allBut } from "../../../../specimen/all_but";
import type { EditorContext } from "../../../../ui/editor_context";
import type { Point } from "../../../../ui/handles/point";
import type { BoundedSpecimen, Knot } from "../bounded";
import { FROM_ABOVE, FROM_FRONT } from "./facing";
import { contourOf } from "./mesh_outline";
import { type Form, outlineOf } from "./outline";

/** Corners of what is round, from above. */
const ROUND = 64;

/** The least height and width that a drag leaves, metres. */
export const LEAST = 0.02;

type Parameters = Readonly<Partial<Record<string, number>>>;

/** The box that a boundary fills. */
export interface Box {
	readonly halfWidth: number;
	readonly low: number;
	readonly high: number;
}

export interface BoundaryLayout<S extends BoundedSpecimen = BoundedSpecimen> {
	form(specimen: S): Form;
	/** The profile of a spline that the specimen does not say. */
	readonly profile: readonly Knot[];
	box(specimen: S): Box;
	/** Where the axes of its boundaries stand, from left to right. */
	axes(specimen: S): readonly number[];
	/** How far the boundary reaches to the front and to the back of its axis. */
	halfDepth(specimen: S): number;
	/** Where particles make for unless the specimen says: x, y, z of each. */
	targets(specimen: S): readonly number[];
	/** What is needed of the parameters for that depth to be another. */
	deepen(specimen: S, halfDepth: number): Parameters;
	/** What is needed of the parameters for the box to be another. */
	fit(specimen: S, box: Box): Parameters;
	/** What is needed for the last axis to stand elsewhere; undefined where there is one. */
	move?(specimen: S, axis: number): Parameters | undefined;
	/** What a target is, in words: where it stands. */
	readonly target: string;
	/** What the box's upper and lower end are called. */
	readonly ends: { readonly high: string; readonly low: string };
	/** The height about which the inner boundary is the outer one made smaller. */
	bareAbout(box: Box): number;
}

/** All that lays out a boundary: how far particles have run to fill it does not, nor how old it is. */
export function layoutInputs<S extends BoundedSpecimen>({
	state,
	preset,
}: Pick<EditorContext<S>, "state" | "preset">): unknown[] {
	return [preset, ...allBut(state.specimen, ["age"])];
}

/** How large a box is, metres. */
export function sizeOf({ halfWidth, low, high }: Box): number {
	return Math.max(halfWidth, high - low);
}

/** The axis that grips stand at: the last one, where there are several. */
export function axisOf<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): number {
	return layout.axes(specimen).at(-1) ?? 0;
}

/** Of width that reaches out to one side, and of depth that was the same: round stays round. */
export function roundly({ parameters }: BoundedSpecimen, halfWidth: number): Parameters {
	const width = 2 * halfWidth;
	return parameters.depth === parameters.width ? { width, depth: width } : { width };
}

/** So many places evenly across a width, about the middle. */
export function evenlySpaced(count: number, width: number): number[] {
	return Array.from({ length: count }, (_, i) => width * ((i + 0.5) / count - 0.5));
}

/** The outline of a specimen's boundary, in shares of its box. */
export function outlineIn<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): readonly Knot[] {
	return outlineOf(layout.form(specimen), specimen.profile ?? layout.profile, specimen.volume);
}

/** The boundary from in front as closed loops in shares of its box: across −1 … 1, from below 0 … 1. */
export function loopsIn<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
): readonly (readonly Point[])[] {
	if (layout.form(specimen) === "mesh" && specimen.volume) return contourOf(specimen.volume, FROM_FRONT.up);
	const right = outlineIn(layout, specimen).map(([x, y]) => ({ x, y }));
	return [[...right, ...right.map(({ x, y }) => ({ x: -x, y })).reverse()]];
}

/** The boundary from above: across and to the back −1 … 1. */
export function footprintIn<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
): readonly (readonly Point[])[] {
	const form = layout.form(specimen);
	if (form === "mesh" && specimen.volume) return contourOf(specimen.volume, FROM_ABOVE.up);
	if (form === "box") return [[[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => ({ x, y }))]; // biome-ignore format: a square
	const widest = Math.max(...outlineIn(layout, specimen).map(([radius]) => radius));
	const turn = Array.from({ length: ROUND }, (_, i) => (2 * Math.PI * i) / ROUND);
	return [turn.map((angle) => ({ x: widest * Math.cos(angle), y: widest * Math.sin(angle) }))];
}
