/** One sentence about whatever of the panel is under the pointer or in focus: a parameter or a measure. */
import type { Specimen } from "../specimen/specimen";
import { type Entry, type Table, valueIn } from "../specimen/table";

export interface Explained {
	readonly key: string;
	readonly label: string;
	/** The paper's symbol, or empty. */
	readonly symbol: string;
	readonly text: string;
}

export const FIRST_WORDS = "Drag a handle or a slider. Double-click a slider to bring its preset's value back.";

/** What the panel's `data-key` stands for; measures have `measure-` before their key. */
export function explainedBy(table: Table, key: string): Explained | undefined {
	const entry = table.entry(key);
	if (entry) return { key, label: entry.label, symbol: entry.symbol, text: `${entry.help} ${range(entry)}` };
	const measure = table.measures.find((each) => `measure-${each.key}` === key);
	return measure && { key, label: measure.label, symbol: "", text: measure.help };
}

/** The preset's value of a parameter as a person reads it; undefined for what is no parameter. */
export function presetInWords(table: Table, preset: Specimen, key: string): string | undefined {
	const entry = table.entry(key);
	if (!entry) return undefined;
	const value = valueIn(preset, entry);
	return entry.kind === "choice" ? entry.options[Number(value)] : String(value);
}

function range(entry: Entry): string {
	return entry.kind === "colour" || entry.kind === "choice" ? "" : `${entry.min} … ${entry.max} ${entry.unit}. `;
}
