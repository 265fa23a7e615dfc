/** The mapping from a flat view's units, y up, to its element, and its scale bar. */
import type { Point } from "../../../../ui/handles/point";
import { roundLength } from "../../../../ui/handles/scale_bar";

export interface BoundaryFrame {
	/** Size of the element, CSS pixels. */
	readonly width: number;
	readonly height: number;
	/** CSS pixels per unit. */
	readonly scale: number;
	/** Position of the origin, CSS pixels from the upper left corner. */
	readonly origin: Point;
}

/** Maps a point of the view to CSS pixels. */
export function toScreen({ origin, scale }: BoundaryFrame, { x, y }: Point): Point {
	return { x: origin.x + scale * x, y: origin.y - scale * y };
}

/** Maps CSS pixels to a point of the view. */
export function fromScreen({ origin, scale }: BoundaryFrame, { x, y }: Point): Point {
	return { x: (x - origin.x) / scale, y: (origin.y - y) / scale };
}

/** The region that a view shows, in its units. */
export interface BoundaryExtent {
	readonly halfWidth: number;
	readonly low: number;
	readonly high: number;
}

/** Ratio of two neighbouring scales: with continuous scales, each move of a slider would resize the view. */
const STEP = 1.2;
/** Margin around the region, CSS pixels: about a grip's radius. */
const MARGIN = 18;

/**
 * Returns the frame that shows a region in the middle of an element, at a scale that is a power of STEP.
 * @param width of the element, CSS pixels
 */
export function frameAbout({ halfWidth, low, high }: BoundaryExtent, width: number, height: number): BoundaryFrame {
	const scaleX = Math.max(1, width - 2 * MARGIN) / (2 * halfWidth);
	const scaleY = Math.max(1, height - 2 * MARGIN) / (high - low);
	const scale = STEP ** Math.floor(Math.log(Math.min(scaleX, scaleY)) / Math.log(STEP));
	return { width, height, scale, origin: { x: width / 2, y: height / 2 + (scale * (low + high)) / 2 } };
}

/** Returns a scale bar for the longest round length that takes at most a quarter of the view, metres. */
export function scaleBar({ width, scale }: Pick<BoundaryFrame, "width" | "scale">): { length: number; label: string } {
	const length = roundLength(width / 4 / scale);
	return { length, label: length >= 0.995 ? `${Math.round(length)} m` : `${Math.round(100 * length)} cm` };
}
