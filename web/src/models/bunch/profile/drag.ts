/**
 * Effects of drags and arrow keys on the profile: pure functions from parameters to new parameters, in pixels of the
 * profile (handles.ts), clamped to the table's ranges and rounded to whole pixels.
 */

import type { CoreEntry } from "../../../specimen/table";
import { ARROWS, type Point } from "../../../ui/handles/point";
import { BUNCH_TABLE } from "../table";
import {
	type BunchShape,
	type Handle,
	handleKeys,
	handlePosition,
	isSide,
	type Locks,
	type ShapeKey,
	SIDE_HANDLES,
	SIDES,
} from "./handles";

export interface DragOptions {
	/** Pairs whose handles move as mirror images of each other. */
	locks?: Locks;
	/** Moves the opposite handle for this change as if its pair were locked. */
	mirror?: boolean;
}

/** Returns the nearest whole pixel in the table's range. */
export function clampPixels(key: ShapeKey, value: number): number {
	const { min, max } = BUNCH_TABLE.entry(key) as CoreEntry;
	return Math.min(Math.max(Math.round(value), min), max) + 0; // −0 is 0
}

/** Sets one number of the profile as its slider does: clamped, and its opposite too if the pair is locked. */
export function setShapeValue<P extends BunchShape>(
	parameters: P,
	key: ShapeKey,
	value: number,
	{ locks, mirror = false }: DragOptions = {},
): P {
	if (!Number.isFinite(value)) return parameters;
	const changed: Partial<BunchShape> = { [key]: clampPixels(key, value) };
	return { ...parameters, ...withOpposites(changed, mirror ? BOTH_LOCKED : locks) };
}

const BOTH_LOCKED: Locks = { leftRight: true, frontBack: true };

/** Completes a change by its locks: omitted sides take their opposite's numbers. */
export function withOpposites<C extends Partial<BunchShape>>(changed: C, locks?: Locks): C {
	const completed = { ...changed };
	for (const side of SIDE_HANDLES) {
		const { opposite, lock } = SIDES[side];
		if (!locks?.[lock]) continue;
		for (const axis of ["w", "r"] as const) {
			const value = changed[`${side}${axis}`];
			if (value !== undefined && changed[`${opposite}${axis}`] === undefined) completed[`${opposite}${axis}`] = value;
		}
	}
	return completed;
}

/**
 * Moves a handle to a point of its view. A side handle stays on its side of the axis (w ≥ 0), p2 on the axis. The drop
 * of a side may pass the tip: the table allows it and rd is limited to m − 1 (section 4.2). A coordinate of NaN leaves
 * its number unchanged.
 */
export function dragHandle<P extends BunchShape>(
	parameters: P,
	handle: Handle,
	{ x, y }: Point,
	options?: DragOptions,
): P {
	if (!isSide(handle)) return setShapeValue(parameters, "l", y, options);
	const widened = setShapeValue(parameters, `${handle}w`, SIDES[handle].sign * x, options);
	return setShapeValue(widened, `${handle}r`, y, options);
}

/**
 * Moves a handle by `pixels` for an arrow key; returns undefined for another key, or a direction in which the handle
 * cannot move.
 */
export function nudgeHandle<P extends BunchShape>(
	parameters: P,
	handle: Handle,
	key: string,
	pixels: number,
	options?: DragOptions,
): P | undefined {
	const arrow = ARROWS[key];
	if (!arrow || (!isSide(handle) && arrow.y === 0)) return undefined;
	const { x, y } = handlePosition(parameters, handle);
	// The other coordinate is NaN, so that a step to the side leaves a fractional drop alone.
	const to = { x: arrow.x ? x + arrow.x * pixels : Number.NaN, y: arrow.y ? y - arrow.y * pixels : Number.NaN };
	return dragHandle(parameters, handle, to, options);
}

/** Projects a point on the horizontal or the vertical through `from`, whichever is nearer. */
export function straightened(to: Point, from: Point): Point {
	return Math.abs(to.x - from.x) >= Math.abs(to.y - from.y) ? { x: to.x, y: from.y } : { x: from.x, y: to.y };
}

/** Returns whether two profiles agree in every number that the handles set. */
export function sameShape(a: BunchShape, b: BunchShape, handles: readonly Handle[]): boolean {
	return handles.every((handle) => handleKeys(handle).every((key) => a[key] === b[key]));
}

/** Swaps the right and the left side (p3 and p4). */
export function mirrorLeftRight<P extends BunchShape>(parameters: P): P {
	const { p3w, p3r, p4w, p4r } = parameters;
	return { ...parameters, p3w: p4w, p3r: p4r, p4w: p3w, p4r: p3r };
}

/** Swaps the front and the back side (p5 and p6). */
export function mirrorFrontBack<P extends BunchShape>(parameters: P): P {
	const { p5w, p5r, p6w, p6r } = parameters;
	return { ...parameters, p5w: p6w, p5r: p6r, p6w: p5w, p6r: p5r };
}
