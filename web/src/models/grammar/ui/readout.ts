/** Numbers of a text's plant besides its measures: derivation steps, and the contents of each growth area. */
import { html, nothing } from "lit";
import { term } from "../../../ui/term";
import type { GrammarPlant } from "../grammar_plant";
import { type AreaRecord, grammarRecord } from "../record";

export function readout(plant: GrammarPlant): unknown {
	const { counts } = plant;
	const { areas = [] } = grammarRecord(plant);
	return html`<h3>Derivation</h3>
		<dl>
			${term("Steps", counts.steps)}
		</dl>
		${areas.some(({ volume }) => volume !== undefined) ? areaTable(areas) : nothing}`;
}

const areaTable = (areas: readonly AreaRecord[]): unknown => html`<table>
	<caption>Growth areas</caption>
	<thead><tr><th></th><th scope="col">segments</th><th scope="col" title="Cubic metres">m³</th><th scope="col" title="Share of the surface that has the base of a leaf within one leaf’s length">clothed</th></tr></thead>
	<tbody>${areas.map(
		({ kind, segments, volume = 0, clothed = 0 }, i) =>
			html`<tr><th scope="row">${i + 1} ${kind}</th><td>${segments?.toLocaleString("en-GB") ?? "–"}</td><td>${volume.toPrecision(3)}</td><td>${Math.round(100 * clothed)} %</td></tr>`,
	)}</tbody>
</table>`;
