import { html, nothing } from "lit";
import { symbol } from "../../../ui/symbol";
import { term } from "../../../ui/term";
import type { ReadoutRow } from "../../../ui/tool";
import { type BunchPlant, type Plan, THINNED_WHY } from "../bunch_plant";
import { skinClass } from "../measures";
import { SKIN_COLOUR } from "../measures.generated";
import { metresPerPixel } from "../profile/handles";
import type { BunchSpecimen } from "../specimen";

const SIDES = [
	["Right", "p₃"],
	["Left", "p₄"],
	["Front", "p₅"],
	["Back", "p₆"],
] as const;

/** Reasons for missing berries, for several and for one. */
const WHY: Readonly<Record<(typeof THINNED_WHY)[number], readonly [many: string, one: string]>> = {
	"": ["for no reason told", "for no reason told"],
	"not set": ["flowers that set no berry", "flower that set no berry"],
	"no room": ["found no room to swell", "found no room to swell"],
	outside: ["would have grown outside the outline", "would have grown outside the outline"],
	"by hand": ["taken off by hand", "taken off by hand"],
};

/** Numbers of a bunch: missing berries with reasons, and the paper's own numbers. */
export function readout(grown: BunchPlant, { parameters: { l, unit } }: BunchSpecimen): unknown {
	const scale = 1000 * metresPerPixel(unit);
	const { counts, procedure, plan, second } = grown;
	return html`${missing(grown)}
		<h3>After the paper</h3>
		<dl>
			${term("Berries", counts.berries)} ${procedure === "paper" ? term("Withered pedicels", counts.withered) : nothing}
			${term("Pedicels", counts.pedicels)} ${term("Internodes", counts.internodes)}
			${procedure === "paper" ? term("Internodes cut", counts.cut) : nothing}
			${term("Length", `${tenths(l * scale)} mm`, "l")} ${term("Rachis segments", plan.m, "m")}
		</dl>
		${planTable(plan, "Each side", scale)} ${second ? planTable(second, `Second bunch, m ${second.m}`, scale) : nothing}`;
}

/** Row of the class of the skin's colour, which belongs to the look and is not measured by the core. */
export function skinRow({ look }: BunchSpecimen): ReadoutRow {
	const found = skinClass(look);
	return { ...SKIN_COLOUR, group: "berries", text: found.words, found };
}

/** Lists the numbers of missing berries by reason. */
function missing({ thinned }: BunchPlant): unknown {
	const reasons = THINNED_WHY.map((why) => ({ why, count: thinned.filter((each) => each.why === why).length }));
	const given = reasons.filter(({ count }) => count > 0);
	if (given.length === 0) return nothing;
	return html`<h3>Berries that are not there</h3>
		<ul class="missing">${given.map(({ why, count }) => html`<li data-why=${why}><b>${count}</b> ${WHY[why][count === 1 ? 1 : 0]}</li>`)}</ul>`;
}

const tenths = (value: number) => Math.round(10 * value) / 10;

/**
 * Draws a plan as a table.
 * @param scale millimetres per pixel of the outline
 */
function planTable(plan: Plan, caption: string, scale: number): unknown {
	return html`<table>
		<caption>${caption}</caption>
		<thead><tr><th></th><th scope="col" title="Half-width, millimetres"><i class="symbol">w</i></th><th scope="col" title="Drop, millimetres"><i class="symbol">r</i></th>
			<th scope="col" title="Segments of the longest axis"><i class="symbol">n</i></th><th scope="col" title="Axis at which the side has shrunk to one end structure"><i class="symbol">rd</i></th></tr></thead>
		<tbody>${plan.sides.map(
			({ w, r, n, rd }, side) =>
				html`<tr><th scope="row">${SIDES[side][0]} ${symbol(SIDES[side][1])}</th><td>${tenths(w * scale)}</td><td>${tenths(r * scale)}</td><td>${n}</td><td>${rd}</td></tr>`,
		)}</tbody>
	</table>`;
}
