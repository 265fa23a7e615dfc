/** Measures in words: values with units, and classes of descriptors. */
import { formatDecimals } from "../locale/format";

/** A class of a descriptor: values nearest to `at`, or from `from` on. */
export interface MeasureClass {
	readonly note: number;
	readonly words: string;
	readonly at?: number;
	readonly from?: number;
}

/** A measure: its label, how to write its value, and its classes. */
export interface MeasureInfo {
	readonly key: string;
	readonly label: string;
	readonly group: string;
	/** A share is 0 … 1 and shown in percent; a note's value is its class. */
	readonly kind: "number" | "share" | "whole" | "note";
	/** The unit of the value; empty for shares, counts and notes. */
	readonly unit: string;
	/** Decimals of the displayed value; of a share in percent. */
	readonly decimals: number;
	/** Code of the OIV's descriptor. */
	readonly oiv?: number;
	/** One plain sentence. */
	readonly help: string;
	/** The part that was not compared with its source, such as the limits of classes. */
	readonly unchecked?: string;
	readonly classes?: readonly MeasureClass[];
}

/** A descriptor that the core does not measure: the look alone decides its class. */
export interface Descriptor<S> {
	readonly key: string;
	readonly label: string;
	/** Code of the OIV's descriptor. */
	readonly oiv: number;
	classOf(specimen: S): MeasureClass;
}

export interface MeasureGroup {
	readonly key: string;
	readonly title: string;
}

/** Returns the class of a value; undefined where the measure has no classes or does not apply. */
export function classOf({ classes }: Pick<MeasureInfo, "classes">, value: number): MeasureClass | undefined {
	if (!classes || !Number.isFinite(value)) return undefined;
	return classes.reduce((best, one) => {
		if (one.from !== undefined) return value >= one.from ? one : best;
		return Math.abs(value - (one.at ?? 0)) < Math.abs(value - (best.at ?? 0)) ? one : best;
	});
}

/** Returns the text of a value in the language in use: `1,820 mm`, `94.1 %`, the words of a note, `–` where it does not apply. */
export function measureText(info: MeasureInfo, value: number): string {
	if (!Number.isFinite(value)) return "–";
	if (info.kind === "note") return classOf(info, value)?.words ?? "–";
	if (info.kind === "share") return `${formatDecimals(100 * value, info.decimals)} %`;
	const text = formatDecimals(value, info.decimals);
	return info.unit ? `${text} ${info.unit}` : text;
}

/** Returns the text of a value's class in a table: `7 long`; empty without one. */
export function classText(info: MeasureInfo, value: number): string {
	const found = classOf(info, value);
	return found ? `${found.note} ${found.words}` : "";
}
