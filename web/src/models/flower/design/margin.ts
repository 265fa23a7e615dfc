/** An outline that was drawn or traced: half widths at places along an organ, and a smooth curve through them. */
import type { Width } from "./shapes";

/** Both from 0 to 1: from the foot to the tip, and from the vein to the widest there is. */
export interface MarginPoint {
	readonly along: number;
	readonly out: number;
}

/** From the foot to the tip, whose `along` is 0 and 1. */
export type Margin = readonly MarginPoint[];

/** So many are shown to be dragged, the ends among them. */
export const KNOTS = 9;

/** An even outline's points, to draw on from. */
export function marginOf(width: Width): Margin {
	const places = Array.from({ length: KNOTS }, (_, i) => i / (KNOTS - 1));
	const fine = Array.from({ length: 201 }, (_, i) => width(i / 200) || 0);
	const most = Math.max(...fine, 1e-6);
	return places.map((along) => ({ along, out: round(Math.max(0, (width(along) || 0) / most)) }));
}

const round = (value: number): number => Math.round(value * 1000) / 1000;

/** A point where it is taken to: between its neighbours, the ends only in and out, and so those that have no room. */
export function moved(margin: Margin, index: number, to: MarginPoint): Margin {
	const [before, after] = [margin[index - 1], margin[index + 1]];
	const room = before && after && after.along - before.along >= 2 * APART;
	const along = room ? round(within(to.along, before.along + APART, after.along - APART)) : margin[index].along;
	return margin.map((point, i) => (i === index ? { along, out: round(within(to.out, 0, 1)) } : point));
}

/** Points are dragged no nearer to each other; a hand may write them nearer. */
const APART = 0.02;

const within = (value: number, least: number, most: number): number => Math.min(most, Math.max(least, value));

/** The curve through the points: cubic between them, never beyond them (Fritsch and Butland 1984). */
export function widthOf(margin: Margin): Width {
	const steps = margin.slice(1).map(({ along, out }, i) => (out - margin[i].out) / (along - margin[i].along));
	const slope = (i: number): number => {
		if (i === 0) return steps[0];
		if (i === steps.length) return steps[i - 1];
		const [one, other] = [steps[i - 1], steps[i]];
		return one * other <= 0 ? 0 : (2 * one * other) / (one + other);
	};
	const slopes = margin.map((_, i) => slope(i));
	return (u) => {
		const at = Math.max(
			0,
			Math.min(
				margin.length - 2,
				margin.findLastIndex(({ along }) => along <= u),
			),
		);
		const [a, b] = [margin[at], margin[at + 1]];
		const wide = b.along - a.along;
		const t = within((u - a.along) / wide, 0, 1);
		const [t2, t3] = [t * t, t * t * t];
		const value =
			(2 * t3 - 3 * t2 + 1) * a.out +
			(t3 - 2 * t2 + t) * wide * slopes[at] +
			(3 * t2 - 2 * t3) * b.out +
			(t3 - t2) * wide * slopes[at + 1];
		return Math.max(0, value);
	};
}

/** `0:0.1,0.5:1,1:0`, as a description holds it. */
export const writtenMargin = (margin: Margin): string => margin.map(({ along, out }) => `${along}:${out}`).join(",");

/** The other way round; undefined where it is none. */
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
