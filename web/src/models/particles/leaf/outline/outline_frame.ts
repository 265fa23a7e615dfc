/** How an outline lies in the element that shows it: y up, the whole leaf in view. */
import { roundLength } from "../../../../controls/handles/scale_bar";
import type { Place } from "./points";

export interface OutlineFrame {
	/** Size of the element, CSS pixels. */
	width: number;
	height: number;
	/** What is in its middle, in lengths of the leaf. */
	centre: Place;
	/** CSS pixels to a length of the leaf. */
	scale: number;
}

/** Pixels left free around the leaf: at its sides a handle must not be cut, below is the scale bar. */
const MARGIN = { side: 16, top: 16, bottom: 34 };
/** How much of the petiole is seen, in lengths of the leaf. */
export const STUB = 0.07;
/** A view is kept while the leaf fills this share of what it could. */
const FULL_ENOUGH = 0.8;

export function fittedFrame(curve: readonly Place[], width: number, height: number): OutlineFrame {
	const { left, right, bottom, top } = boundsOf(curve);
	const across = Math.max(width - 2 * MARGIN.side, 1) / Math.max(right - left, 0.01);
	const up = Math.max(height - MARGIN.top - MARGIN.bottom, 1) / Math.max(top - bottom, 0.01);
	const scale = Math.min(across, up);
	const lower = (MARGIN.bottom - MARGIN.top) / 2 / scale;
	return { width, height, scale, centre: { x: (left + right) / 2, y: (bottom + top) / 2 - lower } };
}

/**
 * The frame to go on with: the one before while a hand moves a point, and after it where the leaf still fits well: a view
 * that rescaled after every drag would unsettle.
 */
export function steadyFrame(
	before: OutlineFrame | undefined,
	curve: readonly Place[],
	{ width, height }: { width: number; height: number },
	held: boolean,
): OutlineFrame {
	if (before?.width === width && before.height === height && (held || suits(before, curve))) return before;
	return fittedFrame(curve, width, height);
}

function suits(frame: OutlineFrame, curve: readonly Place[]): boolean {
	const { left, right, bottom, top } = boundsOf(curve);
	const [low, high] = [inView(frame, { x: left, y: bottom }), inView(frame, { x: right, y: top })];
	const whole = low.x >= 6 && high.x <= frame.width - 6 && high.y >= 6 && low.y <= frame.height - 20;
	return whole && frame.scale >= FULL_ENOUGH * fittedFrame(curve, frame.width, frame.height).scale;
}

/** A place of the leaf in CSS pixels from the element's top left corner. */
export function inView({ width, height, centre, scale }: OutlineFrame, { x, y }: Place): Place {
	return { x: width / 2 + (x - centre.x) * scale, y: height / 2 - (y - centre.y) * scale };
}

/** The place of the leaf that is there. */
export function onLeaf({ width, height, centre, scale }: OutlineFrame, { x, y }: Place): Place {
	return { x: centre.x + (x - width / 2) / scale, y: centre.y - (y - height / 2) / scale };
}

export interface ScaleBar {
	/** CSS pixels. */
	length: number;
	/** "2 cm". */
	label: string;
}

/**
 * The longest round length that takes at most a third of the view.
 * @param millimetres of a length of the leaf
 */
export function scaleBar({ width, scale }: OutlineFrame, millimetres: number): ScaleBar {
	const length = roundLength(((width / 3) * millimetres) / scale);
	return { length: (length / millimetres) * scale, label: length >= 10 ? `${length / 10} cm` : `${length} mm` };
}

function boundsOf(places: readonly Place[]) {
	const [xs, ys] = [places.map(({ x }) => x), places.map(({ y }) => y)];
	return { left: Math.min(...xs), right: Math.max(...xs), bottom: Math.min(...ys, -STUB), top: Math.max(...ys) };
}
