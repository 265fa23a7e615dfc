/** Numbers as people read them: a model whose parameters are lengths in a unit of its own shows them in millimetres. */
import type { Specimen } from "./specimen";
import type { Entry, NumberEntry } from "./table";

/** Millimetres to one of each unit that a model counts lengths in besides, as its table writes them: `px`. */
export type OwnLengths = Readonly<Record<string, number>>;

/** A parameter as it is read and typed. */
export interface Scale {
	/** Of this to one of the table's unit. */
	readonly per: number;
	readonly unit: string;
	/** Digits after the point. */
	readonly decimals: number;
}

/** Steps of less than this many millimetres are read to a hundredth. */
const FINE = 0.3;

/** How a specimen's values of a parameter are read. */
export function scaleOf<S extends Specimen>(
	species: { lengths?(specimen: S): OwnLengths },
	specimen: S,
	{ unit }: Pick<Entry, "unit">,
): Scale {
	const per = species.lengths?.(specimen)[unit];
	if (per === undefined) return { per: 1, unit, decimals: 2 };
	return { per, unit: "mm", decimals: per < FINE ? 2 : 1 };
}

/** A value as it is read, without its unit: no more digits than the scale has, and none that say nothing. */
export function readIn({ per, decimals }: Scale, value: number): number {
	const tens = 10 ** decimals;
	return Math.round(value * per * tens) / tens;
}

/** A value of an entry as a field shows it. */
export function readOf({ zero }: { readonly zero?: string }, scale: Scale, value: number): string {
	return value === 0 && zero !== undefined ? zero : String(readIn(scale, value));
}

/** A number that was typed for an entry, `zero` in words included. */
export function typedOf({ zero }: { readonly zero?: string }, text: string, typed: number): number {
	return zero !== undefined && text.trim().toLowerCase() === zero ? 0 : typed;
}

/** How far an entry goes: "12.5 … 250 mm.", "whole numbers 0 (auto) … 400." */
export function rangeInWords({ min, max, kind, zero }: NumberEntry, scale: Scale): string {
	const { unit, per } = scale;
	const least = `${readIn(scale, min)}${min === 0 && zero !== undefined ? ` (${zero})` : ""}`;
	return `${kind === "integer" && per === 1 ? "whole numbers " : ""}${least} … ${readIn(scale, max)}${unit ? ` ${unit}` : ""}.`;
}
