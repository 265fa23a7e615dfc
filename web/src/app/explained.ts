/** One sentence about whatever of the panel is under the pointer or in focus: a parameter or a measure. */
import { readIn, readOf, type Scale, scaleOf } from "../specimen/lengths";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";
import { type Entry, valueIn } from "../specimen/table";

export interface Explained {
	readonly key: string;
	readonly label: string;
	/** The paper's symbol, or empty. */
	readonly symbol: string;
	readonly text: string;
}

export const FIRST_WORDS =
	"What is under the pointer is explained here. Double-click a slider to bring its preset's value back.";

/** What the panel's `data-key` stands for; measures have `measure-` before their key. */
export function explainedBy(schema: ModelSchema, specimen: Specimen, key: string): Explained | undefined {
	const { table } = schema;
	const entry = table.entry(key);
	if (entry)
		return {
			key,
			label: entry.label,
			symbol: entry.symbol,
			text: `${entry.help} ${range(entry, scaleOf(schema, specimen, entry))}`,
		};
	const measure = table.measures.find((each) => `measure-${each.key}` === key);
	return measure && { key, label: measure.label, symbol: "", text: measure.help };
}

/** What a tool's own slider says of itself (ui/slider_row.ts), for what lies in its row. */
export function explainedAt(place: Element): Explained | undefined {
	const slider = place.closest(".control")?.querySelector<HTMLInputElement>("input[data-help]");
	const label = slider?.labels?.[0]?.textContent?.trim() ?? "";
	return slider ? { key: slider.id, label, symbol: "", text: slider.dataset.help ?? "" } : undefined;
}

/** The preset's value of a parameter as a person reads it; undefined for what is no parameter. */
export function presetInWords(schema: ModelSchema, preset: Specimen, key: string): string | undefined {
	const entry = schema.table.entry(key);
	if (!entry) return undefined;
	const value = valueIn(preset, entry);
	if (entry.kind === "choice") return entry.options[Number(value)];
	if (typeof value !== "number" || entry.kind === "colour") return String(value);
	return readOf(entry, scaleOf(schema, preset, entry), value);
}

function range(entry: Entry, scale: Scale): string {
	if (entry.kind === "colour" || entry.kind === "choice") return "";
	return `${readIn(scale, entry.min)} … ${readIn(scale, entry.max)} ${scale.unit}. `;
}
