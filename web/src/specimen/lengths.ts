/**
 * Converts numbers for display: a model whose parameters are lengths in a unit of its own shows them in millimetres.
 */
import { formatNumber } from "../locale/format";
import { text } from "./messages.generated";
import type { Specimen } from "./specimen";
import type { NumberEntry, ParameterEntry } from "./table";

/** Millimetres per unit, for each of a model's own units of length, as its table writes them: `px`. */
export type OwnLengths = Readonly<Record<string, number>>;

/** How a parameter is displayed and typed. */
export interface DisplayScale {
	/** Displayed units per unit of the table. */
	readonly per: number;
	readonly unit: string;
	/** Digits after the point. */
	readonly decimals: number;
}

/** Steps below this many millimetres are displayed to a hundredth. */
const FINE = 0.3;

/** Returns the scale in which a specimen's parameter is displayed. */
export function displayScaleOf<S extends Specimen>(
	schema: { lengths?(specimen: S): OwnLengths },
	specimen: S,
	{ unit }: Pick<ParameterEntry, "unit">,
): DisplayScale {
	const per = schema.lengths?.(specimen)[unit];
	if (per === undefined) return { per: 1, unit, decimals: 2 };
	return { per, unit: "mm", decimals: per < FINE ? 2 : 1 };
}

/** Returns a value as displayed, in the scale's unit, rounded to the scale's decimals. */
export function displayedNumber({ per, decimals }: DisplayScale, value: number): number {
	const tens = 10 ** decimals;
	return Math.round(value * per * tens) / tens;
}

/** Returns the text of an entry's value in its input field. */
export function displayedText({ zero }: { readonly zero?: string }, scale: DisplayScale, value: number): string {
	return value === 0 && zero !== undefined ? zero : String(displayedNumber(scale, value));
}

/**
 * Returns the number of a typed text: 0 for an entry's word for zero ("auto"), else `typed`.
 * @param typed the number that the text holds
 */
export function parseDisplayed({ zero }: { readonly zero?: string }, text: string, typed: number): number {
	return zero !== undefined && text.trim().toLowerCase() === zero ? 0 : typed;
}

/** Returns the range of an entry in words: "12.5 … 1,250 mm.", "Whole numbers, 0 (auto) … 400." */
export function rangeInWords({ min, max, kind, zero }: NumberEntry, scale: DisplayScale): string {
	const { unit, per } = scale;
	const inWords = (value: number) => formatNumber(displayedNumber(scale, value), { maximumFractionDigits: 6 });
	const least = `${inWords(min)}${min === 0 && zero !== undefined ? ` (${zero})` : ""}`;
	const most = `${inWords(max)}${unit ? ` ${unit}` : ""}`;
	return text(kind === "integer" && per === 1 ? "range_whole" : "range", { least, most });
}
