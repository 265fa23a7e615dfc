/** Explains the parameter or measure of the panel that is under the pointer or in focus, in one sentence. */
import { type DisplayScale, displayedNumber, displayedText, displayScaleOf } from "../specimen/lengths";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";
import { type ParameterEntry, valueIn } from "../specimen/table";

export interface Explained {
	readonly key: string;
	readonly label: string;
	/** The paper's symbol, or empty. */
	readonly symbol: string;
	readonly text: string;
}

export const FIRST_WORDS =
	"What is under the pointer is explained here. Double-click a slider to bring its preset's value back.";

/** The explanation for a `data-key` of the panel: a parameter's key, or a measure's key after `measure-`. */
export function explainedBy(schema: ModelSchema, specimen: Specimen, key: string): Explained | undefined {
	const { table } = schema;
	const entry = table.entry(key);
	if (entry)
		return {
			key,
			label: entry.label,
			symbol: entry.symbol,
			text: `${entry.help} ${range(entry, displayScaleOf(schema, specimen, entry))}`,
		};
	const measure = table.measures.find((each) => `measure-${each.key}` === key);
	return measure && { key, label: measure.label, symbol: "", text: measure.help };
}

/** The explanation of the tool slider (ui/slider_row.ts) whose row contains an element. */
export function explainedAt(place: Element): Explained | undefined {
	const slider = place.closest(".control")?.querySelector<HTMLInputElement>("input[data-help]");
	const label = slider?.labels?.[0]?.textContent?.trim() ?? "";
	return slider ? { key: slider.id, label, symbol: "", text: slider.dataset.help ?? "" } : undefined;
}

/** The preset's value of a parameter, formatted with its unit; undefined for keys that are no parameter. */
export function presetInWords(schema: ModelSchema, preset: Specimen, key: string): string | undefined {
	const entry = schema.table.entry(key);
	if (!entry) return undefined;
	const value = valueIn(preset, entry);
	if (entry.kind === "choice") return entry.options[Number(value)];
	if (typeof value !== "number" || entry.kind === "colour") return String(value);
	return displayedText(entry, displayScaleOf(schema, preset, entry), value);
}

function range(entry: ParameterEntry, scale: DisplayScale): string {
	if (entry.kind === "colour" || entry.kind === "choice") return "";
	return `${displayedNumber(scale, entry.min)} … ${displayedNumber(scale, entry.max)} ${scale.unit}. `;
}
