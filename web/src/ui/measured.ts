import { html, nothing } from "lit";
import { classOf, type MeasureInfo, measureText } from "../specimen/measures";
import type { Table } from "../specimen/table";
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
				? [drawn(rowOf(info, measures[index]), request(info, measures[index]))]
				: [],
		);
		if (rows.length === 0) return nothing;
		const last = more.filter((row) => row.group === group).map((row) => drawn(row));
		return html`<section class="measures"><h3>${title}</h3>${rows}${last}</section>`;
	});
}

function rowOf(info: MeasureInfo, value: number): ReadoutRow {
	return { ...info, text: measureText(info, value), found: classOf(info, value) };
}

function drawn({ key, label, help, oiv, unchecked, text, found }: ReadoutRow, request?: unknown): unknown {
	// If a descriptor's value is a note, `text` already has its words.
	const words = found && found.words !== text ? `${found.note}, ${found.words}` : found?.note;
	const classed =
		oiv === undefined || found === undefined
			? nothing
			: html`<small>OIV ${oiv}: class ${words}${unchecked ? html`<abbr title="not compared with its source: ${unchecked}"> ?</abbr>` : nothing}</small>`;
	const doubt = unchecked ? ` Not compared with its source: ${unchecked}.` : "";
	return html`<details class="measure" data-key="measure-${key}" data-measure=${key}>
		<summary><span class="what">${label}${classed}</span><span
			class=${request ? "value askable" : "value"} title=${request ? "Ask for another value" : nothing}
		>${text}</span></summary>
		<p>${help}${doubt}</p>
		${request ?? nothing}
	</details>`;
}
