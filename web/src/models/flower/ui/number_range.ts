/** How far a figure of a flower's text can be slid, and how it is written then. */
import { decimals } from "../../../grammar_editor/outline";
import { written } from "../../../grammar_editor/scrub";

export interface NumberRange {
	readonly min: number;
	readonly max: number;
	readonly step: number;
	/** A value as it is written into the text, brought into the range. */
	written(value: number): string;
}

/** About a hundred steps, of one digit each. */
const STEPS = 200;

/** For a figure as it is now, by what it says: N, atx … m, or a variable. */
export function rangeFor(name: string, value: number): NumberRange {
	if (name === "N") return range(3, Math.max(24, 2 * value), 1);
	if (name === "m") return range(0, Math.max(20, value), 1);
	if (/^at[xyz]$/.test(name)) return range(Math.min(-90, 2 * value), Math.max(90, 2 * value), 1);
	const reach = 2 * Math.abs(value) || 10;
	// Variables that count things stay whole: who wants parts of them types those.
	const whole = Number.isInteger(value) && Math.abs(value) >= 2;
	const fine = 10 ** Math.floor(Math.log10(reach / STEPS) + 0.5);
	// What is counted is divided by, as often as not.
	return range(value < 0 ? -reach : Number(whole), reach, whole ? Math.max(1, fine) : fine);
}

/** That which the text says, or which its slider has among the constants. */
export const statedRange = ({ min, max, step }: Omit<NumberRange, "written">): NumberRange => range(min, max, step);

/** The range as it was, as long as a value is in it. */
export function within(range: NumberRange | undefined, value: number): NumberRange | undefined {
	return range && value >= range.min && value <= range.max ? range : undefined;
}

function range(min: number, max: number, step: number): NumberRange {
	const places = step < 1 ? Math.max(0, decimals(String(Number(step.toFixed(6))))) : 0;
	return { min, max, step, written: (value) => written(Math.min(Math.max(value, min), max), places) };
}
