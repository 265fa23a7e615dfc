/** How an outline lies in the element that shows it: y up, the whole leaf in view. */
import { roundLength } from "../../../ui/handles/scale_bar";
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

/** How far out of view a hand takes a point at once, CSS pixels. */
const OVER = 3;
/** Left free about the leaf at the least, before the view goes back from it. */
const RIM = { side: 6, top: 6, bottom: 20 };

/**
 * The frame to go on with: the one before where the leaf still fits well: a view that rescaled after every drag would
 * unsettle. While a hand moves a point, the view only goes back as far as the whole leaf needs.
 */
export function steadyFrame(
	before: OutlineFrame | undefined,
	curve: readonly Place[],
	{ width, height }: { width: number; height: number },
	held: boolean,
): OutlineFrame {
	if (before?.width === width && before.height === height) {
		const scale = wholeScale(before, curve);
		if (held) return scale < before.scale ? { ...before, scale } : before;
		if (suits(before, curve)) return before;
	}
	return fittedFrame(curve, width, height);
}

function suits(frame: OutlineFrame, curve: readonly Place[]): boolean {
	const whole = frame.scale <= (1 + 1e-6) * wholeScale(frame, curve);
	return whole && frame.scale >= FULL_ENOUGH * fittedFrame(curve, frame.width, frame.height).scale;
}

/** The largest scale at which a leaf is seen whole about a frame's middle. */
function wholeScale({ width, height, centre }: OutlineFrame, curve: readonly Place[]): number {
	const { left, right, bottom, top } = boundsOf(curve);
	const side = (width / 2 - RIM.side) / Math.max(right - centre.x, centre.x - left, 0.01);
	const up = (height / 2 - RIM.top) / Math.max(top - centre.y, 0.01);
	const down = (height / 2 - RIM.bottom) / Math.max(centre.y - bottom, 0.01);
	return Math.max(1, Math.min(side, up, down));
}

/** The nearest place to take a point to: in view, or by so little out of it that the view goes back slowly. */
export function inReach(frame: OutlineFrame, to: Place): Place {
	const { x, y } = inView(frame, to);
	const [left, top] = [RIM.side - OVER, RIM.top - OVER];
	const [right, low] = [frame.width - left, frame.height - RIM.bottom + OVER];
	return onLeaf(frame, { x: Math.min(right, Math.max(left, x)), y: Math.min(low, Math.max(top, y)) });
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
