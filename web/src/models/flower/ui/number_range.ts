/** Slider ranges of numbers in a flower's text, and how their values are written. */
import { decimals } from "../../../grammar_editor/outline";
import { written } from "../../../grammar_editor/scrub";

export interface TokenRange {
	readonly min: number;
	readonly max: number;
	readonly step: number;
	/** Returns a value as text, clamped to the range. */
	written(value: number): string;
}

/** Steps of a slider, about; each step is a round number. */
const STEPS = 200;

/** Returns the range for a number's current value, by its name: N, atx … m, or a variable. */
export function rangeFor(name: string, value: number): TokenRange {
	if (name === "N") return range(3, Math.max(24, 2 * value), 1);
	if (name === "m") return range(0, Math.max(20, value), 1);
	if (/^at[xyz]$/.test(name)) return range(Math.min(-90, 2 * value), Math.max(90, 2 * value), 1);
	const limit = 2 * Math.abs(value) || 10;
	// Variables that seem to be counts stay whole; other values can be typed.
	const isWhole = Number.isInteger(value) && Math.abs(value) >= 2;
	const step = 10 ** Math.floor(Math.log10(limit / STEPS) + 0.5);
	// Counts are often divisors, so they do not reach 0.
	return range(value < 0 ? -limit : Number(isWhole), limit, isWhole ? Math.max(1, step) : step);
}

/** Returns the range given by the text or by the slider of its constant. */
export const statedRange = ({ min, max, step }: Omit<TokenRange, "written">): TokenRange => range(min, max, step);

/** Returns the range if a value is in it, so that it does not change during a drag. */
export function within(range: TokenRange | undefined, value: number): TokenRange | undefined {
	return range && value >= range.min && value <= range.max ? range : undefined;
}

/** Returns a range whose values are written with as many decimals as the step has. */
function range(min: number, max: number, step: number): TokenRange {
	const places = step < 1 ? Math.max(0, decimals(String(Number(step.toFixed(6))))) : 0;
	return { min, max, step, written: (value) => written(Math.min(Math.max(value, min), max), places) };
}
