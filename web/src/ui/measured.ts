import { html, nothing } from "lit";
import { classOf, type MeasureInfo, measureText } from "../specimen/measures";
import type { Table } from "../specimen/table";
import { text } from "./messages.generated";
import type { ReadoutRow } from "./tool";

/**
 * Draws the measures by group, each with its unit, its descriptor's class and an explanation that unfolds. Measures
 * that do not apply are left out.
 * @param measures in the order of the table
 * @param more further rows at the end of their groups; groups without a measure are not shown
 * @param request draws the form that searches for another value of a measure; undefined if it cannot be searched for
 */
export function measured(
	table: Table,
	measures: Float32Array,
	more: readonly ReadoutRow[] = [],
	request: (info: MeasureInfo, value: number) => unknown = () => undefined,
): unknown {
	return table.measureGroups.map(({ key: group, title }) => {
		const rows = table.measures.flatMap((info, index) =>
			info.group === group && Number.isFinite(measures[index])
				? [drawRow(rowOf(info, measures[index]), request(info, measures[index]))]
				: [],
		);
		if (rows.length === 0) return nothing;
		const last = more.filter((row) => row.group === group).map((row) => drawRow(row));
		return html`<section class="measures"><h3>${title}</h3>${rows}${last}</section>`;
	});
}

/** Returns the row of a measure: its value and class in words. */
function rowOf(info: MeasureInfo, value: number): ReadoutRow {
	return { ...info, text: measureText(info, value), found: classOf(info, value) };
}

/**
 * Renders one measure with its value, its class in the OIV's descriptors, and its explanation.
 * @param request control for a target value; undefined where none can be set
 */
function drawRow({ key, label, help, oiv, unchecked, text: value, found }: ReadoutRow, request?: unknown): unknown {
	// If a descriptor's value is a note, `value` already has its words.
	const words =
		found && found.words !== value ? text("oiv_class_note", { note: found.note, words: found.words }) : found?.note;
	const doubt = unchecked ? text("not_compared", { part: unchecked }) : "";
	const classText =
		oiv === undefined || found === undefined
			? nothing
			: html`<small>${text("oiv_class", { oiv: String(oiv), note: words ?? "" })}${doubt ? html`<abbr title=${doubt}> ?</abbr>` : nothing}</small>`;
	return html`<details class="measure" data-key="measure-${key}" data-measure=${key}>
		<summary><span class="what">${label}${classText}</span><span
			class=${request ? "value askable" : "value"} title=${request ? text("set_target") : nothing}
		>${value}</span></summary>
		<p>${help} ${doubt}</p>
		${request ?? nothing}
	</details>`;
}
