/**
 * Maps a model's parameters to the geometry of its boundary, seen from the front, and back. Metres; the ground is at
 * height 0.
 */

import { allBut } from "../../../../specimen/all_but";
import type { EditorContext } from "../../../../ui/editor_context";
import type { Point } from "../../../../ui/handles/point";
import type { BoundedSpecimen, Knot } from "../bounded";
import { FROM_ABOVE, FROM_FRONT } from "./facing";
import { contourOf } from "./mesh_outline";
import { type Form, outlineOf } from "./outline";

/** Corners of a circle seen from above. */
const ROUND = 64;

/** Least height and width after a drag, metres. */
export const LEAST = 0.02;

type Parameters = Readonly<Partial<Record<string, number>>>;

/** Bounding box of a boundary, metres. */
export interface Box {
	readonly halfWidth: number;
	readonly low: number;
	readonly high: number;
}

export interface BoundaryLayout<S extends BoundedSpecimen = BoundedSpecimen> {
	form(specimen: S): Form;
	/** The profile of the shape `spline` where the specimen has none. */
	readonly profile: readonly Knot[];
	box(specimen: S): Box;
	/** x coordinates of the boundaries' axes, from left to right. */
	axes(specimen: S): readonly number[];
	/** Distance from the axis to the front and to the back of the boundary. */
	halfDepth(specimen: S): number;
	/** Default targets: x, y, z of each. */
	targets(specimen: S): readonly number[];
	/** Parameters that give the boundary another depth. */
	deepen(specimen: S, halfDepth: number): Parameters;
	/** Parameters that give the boundary another box. */
	fit(specimen: S, box: Box): Parameters;
	/** Parameters that move the last axis; undefined where there is only one axis. */
	move?(specimen: S, axis: number): Parameters | undefined;
	/** Kind of the targets, a case of their messages. */
	readonly target: "trunk" | "collar";
	/** Labels of the box's upper and lower end. */
	readonly ends: { readonly high: string; readonly low: string };
	/** The fixed height of the inner boundary's scaling. */
	bareAbout(box: Box): number;
}

/** Returns the inputs that a boundary's geometry depends on: all of the specimen except its age. */
export function layoutInputs<S extends BoundedSpecimen>({
	state,
	preset,
}: Pick<EditorContext<S>, "state" | "preset">): unknown[] {
	return [preset, ...allBut(state.specimen, ["age"])];
}

/** Returns the larger of the half width and the height of a box, metres. */
export function sizeOf({ halfWidth, low, high }: Box): number {
	return Math.max(halfWidth, high - low);
}

/** Returns the x coordinate of the axis that has the grips: the last axis. */
export function axisOf<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): number {
	return layout.axes(specimen).at(-1) ?? 0;
}

/** Returns the parameters of a new width; where the depth was equal to the width, it stays so. */
export function roundly({ parameters }: BoundedSpecimen, halfWidth: number): Parameters {
	const width = 2 * halfWidth;
	return parameters.depth === parameters.width ? { width, depth: width } : { width };
}

/** Returns evenly spaced positions across a width, centred on 0. */
export function evenlySpaced(count: number, width: number): number[] {
	return Array.from({ length: count }, (_, i) => width * ((i + 0.5) / count - 0.5));
}

/** Returns the right half of a boundary's outline from below, in shares of its box. */
export function outlineIn<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): readonly Knot[] {
	return outlineOf(layout.form(specimen), specimen.profile ?? layout.profile, specimen.volume);
}

/** Returns the boundary from the front as closed loops in shares of its box: x in −1 … 1, y in 0 … 1 from below. */
export function loopsIn<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
): readonly (readonly Point[])[] {
	if (layout.form(specimen) === "mesh" && specimen.volume) return contourOf(specimen.volume, FROM_FRONT.up);
	const right = outlineIn(layout, specimen).map(([x, y]) => ({ x, y }));
	return [[...right, ...right.map(({ x, y }) => ({ x: -x, y })).reverse()]];
}

/** Returns the boundary from above as closed loops: x and y (to the back) in −1 … 1. */
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
