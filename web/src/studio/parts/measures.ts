import { html, nothing } from "lit";
import { classOf, measureText, skinClass } from "../../models/bunch/measures";
import { MEASURE_GROUPS, MEASURES, type MeasureInfo, SKIN_COLOUR } from "../../models/bunch/measures.generated";
import type { Look } from "../../specimen/specimen";

/** What a row needs of a measure, or of the skin's colour, which is of the look. */
type Row = Pick<MeasureInfo, "key" | "help" | "label" | "oiv" | "unchecked"> | typeof SKIN_COLOUR;

/**
 * What was measured on the bunch, group by group, each with its unit, its descriptor's class, and a sentence that
 * unfolds. What does not apply is left out.
 * @param measures in the order of MEASURES
 */
export function measured(measures: Float32Array, look: Look): unknown {
	return GROUPS.map(({ key: group, title }) => {
		const rows = MEASURES.flatMap((info, index) => {
			const value = measures[index];
			if (info.group !== group || !Number.isFinite(value)) return [];
			const found = classOf(info, value);
			return [row(info, measureText(info, value), found)];
		});
		if (group === "berries" && rows.length > 0) {
			const skin = skinClass(look);
			rows.push(row(SKIN_COLOUR, skin.words, skin));
		}
		return rows.length === 0 ? nothing : html`<section class="measures"><h3>${title}</h3>${rows}</section>`;
	});
}

/** The bunch first; how well it follows the handles is read by fewer. */
const GROUPS = [...MEASURE_GROUPS].sort((a, b) => Number(a.key === "outline") - Number(b.key === "outline"));

function row(
	{ key, label, help, oiv, unchecked }: Row,
	text: string,
	found?: { note: number; words: string },
): unknown {
	// A descriptor whose value is a note has the words for a value already.
	const words = found && found.words !== text ? `${found.note}, ${found.words}` : found?.note;
	const classed =
		oiv === undefined || found === undefined
			? nothing
			: html`<small>OIV ${oiv}: class ${words}${unchecked ? html`<abbr title="not compared with its source: ${unchecked}"> ?</abbr>` : nothing}</small>`;
	const doubt = unchecked ? ` Not compared with its source: ${unchecked}.` : "";
	return html`<details class="measure" data-key="measure-${key}" data-measure=${key}>
		<summary><span class="what">${label}${classed}</span><span class="value">${text}</span></summary>
		<p>${help}${doubt}</p>
	</details>`;
}
