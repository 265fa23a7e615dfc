/**
 * Converts numbers for display: a model whose parameters are lengths in a unit of its own shows them in millimetres.
 */
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

/** The scale in which a specimen's parameter is displayed. */
export function displayScaleOf<S extends Specimen>(
	species: { lengths?(specimen: S): OwnLengths },
	specimen: S,
	{ unit }: Pick<ParameterEntry, "unit">,
): DisplayScale {
	const per = species.lengths?.(specimen)[unit];
	if (per === undefined) return { per: 1, unit, decimals: 2 };
	return { per, unit: "mm", decimals: per < FINE ? 2 : 1 };
}

/** A value as displayed, without its unit and trailing zeros: at most the scale's decimals. */
export function displayedNumber({ per, decimals }: DisplayScale, value: number): number {
	const tens = 10 ** decimals;
	return Math.round(value * per * tens) / tens;
}

/** The text of an entry's value in its input field. */
export function displayedText({ zero }: { readonly zero?: string }, scale: DisplayScale, value: number): string {
	return value === 0 && zero !== undefined ? zero : String(displayedNumber(scale, value));
}

/** The value that was typed for an entry, `zero` in words included. */
export function parseDisplayed({ zero }: { readonly zero?: string }, text: string, typed: number): number {
	return zero !== undefined && text.trim().toLowerCase() === zero ? 0 : typed;
}

/** The range of an entry: "12.5 … 250 mm.", "whole numbers 0 (auto) … 400." */
export function rangeInWords({ min, max, kind, zero }: NumberEntry, scale: DisplayScale): string {
	const { unit, per } = scale;
	const least = `${displayedNumber(scale, min)}${min === 0 && zero !== undefined ? ` (${zero})` : ""}`;
	return `${kind === "integer" && per === 1 ? "whole numbers " : ""}${least} … ${displayedNumber(scale, max)}${unit ? ` ${unit}` : ""}.`;
}
