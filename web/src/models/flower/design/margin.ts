/**
 * A margin: an outline that was drawn or traced, as half widths at positions along an organ, joined by a smooth curve.
 */
import type { Width } from "./shapes";

/**
 * A point of a margin: `along` runs from 0 at the foot to 1 at the tip, `out` from 0 at the vein to 1 at the greatest
 * half width.
 */
export interface MarginPoint {
	readonly along: number;
	readonly out: number;
}

/** Points from the foot (`along` 0) to the tip (`along` 1). */
export type Margin = readonly MarginPoint[];

/** Number of points that are shown as handles, both ends included. */
export const KNOTS = 9;

/** Samples an outline at evenly spaced points, which drawing starts from. */
export function marginOf(width: Width): Margin {
	const places = Array.from({ length: KNOTS }, (_, i) => i / (KNOTS - 1));
	const samples = Array.from({ length: 201 }, (_, i) => width(i / 200) || 0);
	const greatestWidth = Math.max(...samples, 1e-6);
	return places.map((along) => ({ along, out: round(Math.max(0, (width(along) || 0) / greatestWidth)) }));
}

/** Rounds to thousandths. */
const round = (value: number): number => Math.round(value * 1000) / 1000;

/**
 * Moves a point, limited by its neighbours. The ends and points without room between their neighbours move in and out
 * only.
 */
export function moved(margin: Margin, index: number, to: MarginPoint): Margin {
	const [before, after] = [margin[index - 1], margin[index + 1]];
	const hasRoom = before && after && after.along - before.along >= 2 * LEAST_DISTANCE;
	const along = hasRoom
		? round(within(to.along, before.along + LEAST_DISTANCE, after.along - LEAST_DISTANCE))
		: margin[index].along;
	return margin.map((point, i) => (i === index ? { along, out: round(within(to.out, 0, 1)) } : point));
}

/** Least distance along the organ between dragged points; text edited by hand may have smaller ones. */
const LEAST_DISTANCE = 0.02;

/** Limits a value to a range. */
const within = (value: number, least: number, most: number): number => Math.min(most, Math.max(least, value));

/** Returns the monotone cubic interpolation of the points, which never overshoots them (Fritsch and Butland 1984). */
export function widthOf(margin: Margin): Width {
	const steps = margin.slice(1).map(({ along, out }, i) => (out - margin[i].out) / (along - margin[i].along));
	const slope = (i: number): number => {
		if (i === 0) return steps[0];
		if (i === steps.length) return steps[i - 1];
		const [before, after] = [steps[i - 1], steps[i]];
		return before * after <= 0 ? 0 : (2 * before * after) / (before + after);
	};
	const slopes = margin.map((_, i) => slope(i));
	return (u) => {
		const segment = Math.max(
			0,
			Math.min(
				margin.length - 2,
				margin.findLastIndex(({ along }) => along <= u),
			),
		);
		const [a, b] = [margin[segment], margin[segment + 1]];
		const span = b.along - a.along;
		const t = within((u - a.along) / span, 0, 1);
		const [t2, t3] = [t * t, t * t * t];
		// Cubic Hermite interpolation.
		const value =
			(2 * t3 - 3 * t2 + 1) * a.out +
			(t3 - 2 * t2 + t) * span * slopes[segment] +
			(3 * t2 - 2 * t3) * b.out +
			(t3 - t2) * span * slopes[segment + 1];
		return Math.max(0, value);
	};
}

/** Writes a margin as a description holds it: `0:0.1,0.5:1,1:0`. */
export const writtenMargin = (margin: Margin): string => margin.map(({ along, out }) => `${along}:${out}`).join(",");

/** Parses a margin written by `writtenMargin`; returns undefined if the text is invalid. */
export function readMargin(text: string): Margin | undefined {
	const points = text.split(",").map((pair) => {
		const [along, out] = pair.split(":").map(Number);
		return { along, out };
	});
	const fits = points.every(
		({ along, out }, i) => out >= 0 && out <= 1 && (i === 0 ? along === 0 : along > points[i - 1].along + 0.001),
	);
	return fits && points.length >= 3 && points.length <= 24 && points[points.length - 1].along === 1
		? points
		: undefined;
}
