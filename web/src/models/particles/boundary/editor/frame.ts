/** How a flat view's units, y up, lie in its element, and how long a scale bar suits it. */
import type { Point } from "../../../../ui/handles/point";
import { roundLength } from "../../../../ui/handles/scale_bar";

export interface Frame {
	/** Of the element, CSS pixels. */
	readonly width: number;
	readonly height: number;
	/** CSS pixels to a unit. */
	readonly scale: number;
	/** Where the origin lies, CSS pixels from the upper left corner. */
	readonly origin: Point;
}

export function toScreen({ origin, scale }: Frame, { x, y }: Point): Point {
	return { x: origin.x + scale * x, y: origin.y - scale * y };
}

export function fromScreen({ origin, scale }: Frame, { x, y }: Point): Point {
	return { x: (x - origin.x) / scale, y: (origin.y - y) / scale };
}

/** What a view is to show, in its units. */
export interface Extent {
	readonly halfWidth: number;
	readonly low: number;
	readonly high: number;
}

/** Sizes go in steps of a fifth, so that a view does not swell and shrink with every touch of a slider. */
const STEP = 1.2;
/** Left free around what is shown, CSS pixels: about a grip's reach. */
const MARGIN = 18;

/** The frame that shows an extent in the middle of an element. */
export function frameAbout({ halfWidth, low, high }: Extent, width: number, height: number): Frame {
	const wide = Math.max(1, width - 2 * MARGIN) / (2 * halfWidth);
	const tall = Math.max(1, height - 2 * MARGIN) / (high - low);
	const scale = STEP ** Math.floor(Math.log(Math.min(wide, tall)) / Math.log(STEP));
	return { width, height, scale, origin: { x: width / 2, y: height / 2 + (scale * (low + high)) / 2 } };
}

/** The longest round length that takes at most a quarter of the view, in metres. */
export function scaleBar({ width, scale }: Pick<Frame, "width" | "scale">): { length: number; label: string } {
	const length = roundLength(width / 4 / scale);
	return { length, label: length >= 0.995 ? `${Math.round(length)} m` : `${Math.round(100 * length)} cm` };
}
