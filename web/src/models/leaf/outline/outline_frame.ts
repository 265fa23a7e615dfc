/** The mapping from an outline to its element: y up, the whole leaf visible. */
import { roundLength } from "../../../ui/handles/scale_bar";
import type { Place } from "./points";

export interface OutlineFrame {
	/** Size of the element, CSS pixels. */
	width: number;
	height: number;
	/** The point at the element's centre, in leaf lengths. */
	centre: Place;
	/** CSS pixels per leaf length. */
	scale: number;
}

/** Margins around the leaf, pixels: at the sides for handles, at the bottom for the scale bar. */
const MARGIN = { side: 16, top: 16, bottom: 34 };
/** Visible length of the petiole, in leaf lengths. */
export const STUB = 0.07;
/** The frame stays while the leaf fills this share of the size that it could have. */
const FULL_ENOUGH = 0.8;

/** Returns the frame in which the whole leaf is visible and as large as possible. */
export function fittedFrame(curve: readonly Place[], width: number, height: number): OutlineFrame {
	const { left, right, bottom, top } = boundsOf(curve);
	const scaleX = Math.max(width - 2 * MARGIN.side, 1) / Math.max(right - left, 0.01);
	const scaleY = Math.max(height - MARGIN.top - MARGIN.bottom, 1) / Math.max(top - bottom, 0.01);
	const scale = Math.min(scaleX, scaleY);
	const shift = (MARGIN.bottom - MARGIN.top) / 2 / scale;
	return { width, height, scale, centre: { x: (left + right) / 2, y: (bottom + top) / 2 - shift } };
}

/** Distance by which a drag may take a point out of view at once, CSS pixels. */
const OVER = 3;
/** Least margins around the leaf before the view zooms out, CSS pixels. */
const RIM = { side: 6, top: 6, bottom: 20 };

/**
 * Returns the next frame: the present one while the leaf fits it well, because rescaling after every drag would
 * distract. During a drag the view only zooms out, as far as the whole leaf needs.
 * @param held whether a drag is in progress
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
		if (fillsFrame(before, curve)) return before;
	}
	return fittedFrame(curve, width, height);
}

/** Returns whether the whole leaf is visible in a frame and large enough there. */
function fillsFrame(frame: OutlineFrame, curve: readonly Place[]): boolean {
	const isWhole = frame.scale <= (1 + 1e-6) * wholeScale(frame, curve);
	return isWhole && frame.scale >= FULL_ENOUGH * fittedFrame(curve, frame.width, frame.height).scale;
}

/**
 * Returns the largest scale (CSS pixels per leaf length) at which the whole leaf is visible around a frame's centre.
 */
function wholeScale({ width, height, centre }: OutlineFrame, curve: readonly Place[]): number {
	const { left, right, bottom, top } = boundsOf(curve);
	const sideScale = (width / 2 - RIM.side) / Math.max(right - centre.x, centre.x - left, 0.01);
	const upScale = (height / 2 - RIM.top) / Math.max(top - centre.y, 0.01);
	const downScale = (height / 2 - RIM.bottom) / Math.max(centre.y - bottom, 0.01);
	return Math.max(1, Math.min(sideScale, upScale, downScale));
}

/**
 * Returns the position nearest to `to` that a dragged point may take: in view, or slightly outside, so that the view
 * zooms out slowly.
 */
export function inReach(frame: OutlineFrame, to: Place): Place {
	const { x, y } = inView(frame, to);
	const [left, top] = [RIM.side - OVER, RIM.top - OVER];
	const [right, low] = [frame.width - left, frame.height - RIM.bottom + OVER];
	return onLeaf(frame, { x: Math.min(right, Math.max(left, x)), y: Math.min(low, Math.max(top, y)) });
}

/** Maps a point of the leaf to CSS pixels from the element's top left corner. */
export function inView({ width, height, centre, scale }: OutlineFrame, { x, y }: Place): Place {
	return { x: width / 2 + (x - centre.x) * scale, y: height / 2 - (y - centre.y) * scale };
}

/** Maps CSS pixels to a point of the leaf. */
export function onLeaf({ width, height, centre, scale }: OutlineFrame, { x, y }: Place): Place {
	return { x: centre.x + (x - width / 2) / scale, y: centre.y - (y - height / 2) / scale };
}

export interface LeafScaleBar {
	/** CSS pixels. */
	length: number;
	/** "2 cm". */
	label: string;
}

/**
 * Returns a scale bar for the longest round length that takes at most a third of the view.
 * @param millimetres length of the leaf
 */
export function scaleBar({ width, scale }: OutlineFrame, millimetres: number): LeafScaleBar {
	const length = roundLength(((width / 3) * millimetres) / scale);
	return { length: (length / millimetres) * scale, label: length >= 10 ? `${length / 10} cm` : `${length} mm` };
}

/** Returns the bounds of the leaf with the visible part of its petiole, in leaf lengths. */
function boundsOf(places: readonly Place[]) {
	const [xs, ys] = [places.map(({ x }) => x), places.map(({ y }) => y)];
	return { left: Math.min(...xs), right: Math.max(...xs), bottom: Math.min(...ys, -STUB), top: Math.max(...ys) };
}
