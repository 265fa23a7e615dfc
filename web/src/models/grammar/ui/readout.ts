/** Numbers of a text's plant besides its measures: derivation steps, and the contents of each growth area. */

import { html, nothing } from "lit";
import { formatNumber } from "../../../locale/format";
import { term } from "../../../ui/term";
import type { GrammarPlant } from "../grammar_plant";
import { text } from "../messages.generated";
import { type AreaRecord, grammarRecord } from "../record";

/**
 * Renders the numbers of a text's plant besides its measures: derivation steps, and the contents of each growth area.
 */
export function readout(plant: GrammarPlant): unknown {
	const { counts } = plant;
	const { areas = [] } = grammarRecord(plant);
	return html`<h3>${text("derivation")}</h3>
		<dl>
			${term(text("steps"), counts.steps)}
		</dl>
		${areas.some(({ volume }) => volume !== undefined) ? areaTable(areas) : nothing}`;
}

/** Renders a table of the growth areas with segments, volume and the share of surface that leaves cover. */
const areaTable = (areas: readonly AreaRecord[]): unknown => html`<table>
	<caption>${text("areas")}</caption>
	<thead><tr><td></td><th scope="col">${text("areas_segments")}</th><th scope="col" title=${text("areas_volume")}>m³</th><th scope="col" title=${text("areas_clothed_title")}>${text("areas_clothed")}</th></tr></thead>
	<tbody>${areas.map(
		({ kind, segments, volume = 0, clothed = 0 }, i) =>
			html`<tr><th scope="row">${text("area_row", { number: i + 1, kind })}</th><td>${segments === undefined ? "–" : formatNumber(segments)}</td><td>${formatNumber(volume, { minimumSignificantDigits: 3, maximumSignificantDigits: 3 })}</td><td>${Math.round(100 * clothed)} %</td></tr>`,
	)}</tbody>
</table>`;
