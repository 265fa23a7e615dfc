/** One sentence about whatever of the panel is under the pointer or in focus: a parameter or a measure. */
import { MEASURES } from "../models/bunch/measures.generated";
import { PARAMETERS, type ParameterInfo } from "../models/bunch/parameters.generated";
import type { Specimen } from "../specimen/specimen";

export interface Explained {
	readonly key: string;
	readonly label: string;
	/** The paper's symbol, or empty. */
	readonly symbol: string;
	readonly text: string;
}

export const FIRST_WORDS = "Drag a handle or a slider. Double-click a slider to bring its preset's value back.";

/** What the panel's `data-key` stands for; measures have `measure-` before their key. */
export function explainedBy(key: string): Explained | undefined {
	const info = PARAMETERS.find((each) => each.key === key);
	if (info) return { key, label: info.label, symbol: info.symbol, text: `${info.help} ${range(info)}` };
	const measure = MEASURES.find((each) => `measure-${each.key}` === key);
	return measure && { key, label: measure.label, symbol: "", text: measure.help };
}

/** The preset's value of a parameter as a person reads it; undefined for what is no parameter. */
export function presetInWords({ look, parameters }: Specimen, key: string): string | undefined {
	const value = { ...look, ...parameters }[key as keyof typeof look];
	const options = PARAMETERS.find((each) => each.key === key)?.options;
	if (value === undefined) return undefined;
	return options?.[Number(value)] ?? String(value);
}

function range({ kind, min, max, unit }: ParameterInfo): string {
	return kind === "colour" || kind === "choice" ? "" : `${min} … ${max} ${unit}. `;
}
