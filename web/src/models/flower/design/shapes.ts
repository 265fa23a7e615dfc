/**
 * Table of outlines: the half width of leaves, sepals and petals along their length. The thesis stores coefficients in
 * a database (section 3.3.1) and prints none; here each outline's formula is fitted on request, like drawn outlines.
 */
import { type Coefficients, errorOf, fitted, type Sample } from "./polynomial";

/** Half width, from 0 to 1, at a share of the length, from 0 at the foot to 1 at the tip. */
export type Width = (along: number) => number;

export interface OutlineShape {
	readonly width: Width;
	/** Whether steps have equal lengths; otherwise they are cosine-spaced, which rounded tips need. */
	readonly even?: boolean;
	/** Angle by which the lobes at the foot turn back, degrees. */
	readonly fan?: number;
}

/** Returns a width with one hump, u^rise × (1 − u)^fall; it is not normalised. */
const beta =
	(rise: number, fall: number): Width =>
	(u) =>
		u ** rise * (1 - u) ** fall;
/** Returns 0 up to `from`, 1 from `to` on, and a smooth transition between them. */
const smoothstep = (from: number, to: number, u: number): number => {
	const t = Math.min(1, Math.max(0, (u - from) / (to - from)));
	return t * t * (3 - 2 * t);
};

/**
 * Outlines by their botanical names; `apical` and `tulip` are the thesis's. The formulas are our own; their heights
 * are normalised later.
 */
export const SHAPES: Readonly<Record<string, OutlineShape>> = {
	rounded: { width: beta(0.5, 0.5) },
	elliptic: { width: beta(0.8, 0.8) },
	ovate: { width: beta(0.6, 1.2) },
	obovate: { width: beta(1.2, 0.6) },
	lanceolate: { width: beta(0.8, 1.8) },
	oblanceolate: { width: beta(1.8, 0.8) },
	oblong: { width: (u) => (1 - Math.abs(2 * u - 1) ** 5) ** 0.6 },
	linear: { width: (u) => (0.75 + 0.25 * smoothstep(0, 0.3, u)) * (1 - smoothstep(0.55, 1.1, u)), even: true },
	acicular: { width: (u) => (0.35 + 0.65 * smoothstep(0, 0.35, u)) * (1 - u ** 1.6), even: true },
	apical: { width: (u) => (0.3 + 1.5 * u) * (1 - u) ** 0.95 },
	cordate: { width: (u) => (0.6 + 1.9 * u) * (1 - u), fan: 55 },
	spatulate: { width: (u) => 0.12 * (1 - u) ** 2 + u ** 3 * (1 - u) ** 0.6 },
	tulip: { width: (u) => (0.42 + 0.58 * smoothstep(-0.05, 0.6, u)) * (1 - u ** 3.2) ** 0.62 },
};

/** Value of `outline` for a drawn margin; `OUTLINES` are all valid values. */
export const DRAWN = "drawn";
export const OUTLINES: readonly string[] = [...Object.keys(SHAPES), DRAWN];

const SAMPLES = 96;

/** A polynomial fitted to an outline, with its error. */
export interface OutlineFit {
	readonly coefficients: Coefficients;
	/** Largest distance from the outline, as a share of the greatest half width. */
	readonly error: number;
	readonly even: boolean;
	readonly fan: number;
}

/** Maps a share of the steps to a share of the length. */
export const alongAt = (t: number, even: boolean): number => (even ? t : (1 - Math.cos(Math.PI * t)) / 2);

/** Maps a share of the length to a share of the steps; the inverse of `alongAt`. */
export const stepAt = (along: number, even: boolean): number => (even ? along : Math.acos(1 - 2 * along) / Math.PI);

/** Fits a shape's polynomial, a function of the share of the steps. */
export function fitOf({ width, even = false, fan = 0 }: OutlineShape): OutlineFit {
	const raw = Array.from({ length: SAMPLES + 1 }, (_, i): Sample => {
		const t = i / SAMPLES;
		return { t, value: Math.max(0, width(alongAt(t, even)) || 0) };
	});
	const greatest = Math.max(...raw.map(({ value }) => value), 1e-6);
	const samples = raw.map(({ t, value }) => ({ t, value: value / greatest }));
	const coefficients = fitted(samples).map((value) => Math.round(value * 1000) / 1000 + 0);
	return { coefficients, error: errorOf(coefficients, samples), even, fan };
}
