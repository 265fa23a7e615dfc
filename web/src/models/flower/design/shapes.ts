/**
 * The table of shapes: how wide leaves, sepals and petals are along their length. The thesis keeps coefficients in a data base
 * (section 3.3.1) and prints none; here an outline's formula is fitted when it is asked for, and one that is drawn in the same way.
 */
import { type Coefficients, errorOf, fitted, type Sample } from "./polynomial";

/** A half width, from 0 to 1, at each share of the length, from 0 at the foot to 1 at the tip. */
export type Width = (along: number) => number;

export interface Shape {
	readonly width: Width;
	/** Whether steps are of one length; else as a cosine spaces them, without which a polynomial cannot end round. */
	readonly even?: boolean;
	/** How far its foot's lobes turn back, degrees. */
	readonly fan?: number;
}

const humped =
	(rise: number, fall: number): Width =>
	(u) =>
		u ** rise * (1 - u) ** fall;
const easing = (from: number, to: number, u: number): number => {
	const t = Math.min(1, Math.max(0, (u - from) / (to - from)));
	return t * t * (3 - 2 * t);
};

/** By what botanists call them; `apical` and `tulip` are the thesis's. Formulas are ours, of any height: they are measured. */
export const SHAPES: Readonly<Record<string, Shape>> = {
	rounded: { width: humped(0.5, 0.5) },
	elliptic: { width: humped(0.8, 0.8) },
	ovate: { width: humped(0.6, 1.2) },
	obovate: { width: humped(1.2, 0.6) },
	lanceolate: { width: humped(0.8, 1.8) },
	oblanceolate: { width: humped(1.8, 0.8) },
	oblong: { width: (u) => (1 - Math.abs(2 * u - 1) ** 5) ** 0.6 },
	linear: { width: (u) => (0.75 + 0.25 * easing(0, 0.3, u)) * (1 - easing(0.55, 1.1, u)), even: true },
	acicular: { width: (u) => (0.35 + 0.65 * easing(0, 0.35, u)) * (1 - u ** 1.6), even: true },
	apical: { width: (u) => (0.3 + 1.5 * u) * (1 - u) ** 0.95 },
	cordate: { width: (u) => (0.6 + 1.9 * u) * (1 - u), fan: 55 },
	spatulate: { width: (u) => 0.12 * (1 - u) ** 2 + u ** 3 * (1 - u) ** 0.6 },
	tulip: { width: (u) => (0.42 + 0.58 * easing(-0.05, 0.6, u)) * (1 - u ** 3.2) ** 0.62 },
};

/** What `outline` may be: one of the table's, or drawn. */
export const DRAWN = "drawn";
export const OUTLINES: readonly string[] = [...Object.keys(SHAPES), DRAWN];

const SAMPLES = 96;

/** A polynomial that follows an outline, and how nearly. */
export interface Fit {
	readonly coefficients: Coefficients;
	/** The largest distance, a share of the greatest half width. */
	readonly error: number;
	readonly even: boolean;
	readonly fan: number;
}

/** How far up a step stands. */
export const alongAt = (t: number, even: boolean): number => (even ? t : (1 - Math.cos(Math.PI * t)) / 2);

/** The same the other way round. */
export const stepAt = (along: number, even: boolean): number => (even ? along : Math.acos(1 - 2 * along) / Math.PI);

/** A shape's polynomial of the step's share of all steps. */
export function fitOf({ width, even = false, fan = 0 }: Shape): Fit {
	const raw = Array.from({ length: SAMPLES + 1 }, (_, i): Sample => {
		const t = i / SAMPLES;
		return { t, value: Math.max(0, width(alongAt(t, even)) || 0) };
	});
	const most = Math.max(...raw.map(({ value }) => value), 1e-6);
	const samples = raw.map(({ t, value }) => ({ t, value: value / most }));
	const coefficients = fitted(samples).map((value) => Math.round(value * 1000) / 1000 + 0);
	return { coefficients, error: errorOf(coefficients, samples), even, fan };
}
