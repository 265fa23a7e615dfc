/** Numbers as people read them: a model whose parameters are lengths in a unit of its own shows them in millimetres. */
import type { Specimen } from "./specimen";
import type { Entry } from "./table";

/** The unit of lengths that is a model's own. */
export interface OwnLengths<S extends Specimen = Specimen> {
	/** As the table writes it: `px`. */
	readonly unit: string;
	/** What it is called beside the millimetres: "pixels of the paper". */
	readonly title: string;
	/** Millimetres to one of it. */
	millimetres(specimen: S): number;
}

/** A parameter as it is read and typed. */
export interface Scale {
	/** Of this to one of the table's unit. */
	readonly per: number;
	readonly unit: string;
	/** Digits after the point. */
	readonly decimals: number;
}

/** How a specimen's values of a parameter are read. */
export function scaleOf<S extends Specimen>(
	{ lengths }: { readonly lengths?: OwnLengths<S> },
	specimen: S,
	{ unit }: Pick<Entry, "unit">,
): Scale {
	return lengths && unit === lengths.unit
		? { per: lengths.millimetres(specimen), unit: "mm", decimals: 1 }
		: { per: 1, unit, decimals: 2 };
}

/** A value as it is read, without its unit: no more digits than the scale has, and none that say nothing. */
export function readIn({ per, decimals }: Scale, value: number): number {
	const tens = 10 ** decimals;
	return Math.round(value * per * tens) / tens;
}
