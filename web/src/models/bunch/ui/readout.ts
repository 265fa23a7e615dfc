import { html, nothing } from "lit";
import { formatNumber } from "../../../locale/format";
import { symbol } from "../../../ui/symbol";
import { term } from "../../../ui/term";
import type { ReadoutRow } from "../../../ui/tool";
import { type BunchPlant, type Plan, THINNED_WHY } from "../bunch_plant";
import { SKIN, skinClass } from "../measures";
import { text } from "../messages.generated";
import { metresPerPixel } from "../profile/handles";
import type { BunchSpecimen } from "../specimen";

const SIDES = [
	["side_right", "p₃"],
	["side_left", "p₄"],
	["side_front", "p₅"],
	["side_back", "p₆"],
] as const;

/** Returns a sentence on the berries that are missing for one reason, with their number as drawn. */
function missingFor(why: (typeof THINNED_WHY)[number], number: number): unknown {
	const count = html`<b>${formatNumber(number)}</b>`;
	switch (why) {
		case "not set":
			return text.pieces("missing_not_set", { berries: number, count });
		case "no room":
			return text.pieces("missing_no_room", { count });
		case "outside":
			return text.pieces("missing_outside", { count });
		case "by hand":
			return text.pieces("missing_by_hand", { count });
		default:
			return text.pieces("missing_other", { count });
	}
}

/** Renders the numbers of a bunch: missing berries with reasons, and the paper's own numbers. */
export function readout(grown: BunchPlant, { parameters: { l, unit } }: BunchSpecimen): unknown {
	const scale = 1000 * metresPerPixel(unit);
	const { counts, procedure, plan, second } = grown;
	return html`${missingList(grown)}
		<h3>${text("model_details")}</h3>
		<dl>
			${term(text("berries"), counts.berries)} ${procedure === "paper" ? term(text("pedicels_withered_term"), counts.withered) : nothing}
			${term(text("pedicels_term"), counts.pedicels)} ${term(text("internodes"), counts.internodes)}
			${procedure === "paper" ? term(text("internodes_cut"), counts.cut) : nothing}
			${term(text("length"), `${formatNumber(roundedToTenths(l * scale))} mm`, "l")} ${term(text("rachis_segments"), plan.m, "m")}
		</dl>
		${planTable(plan, text("each_side"), scale)} ${second ? planTable(second, text("second_bunch", { m: second.m }), scale) : nothing}`;
}

/** Returns the row of the class of the skin's colour, which belongs to the look and is not measured by the core. */
export function skinRow({ look }: BunchSpecimen): ReadoutRow {
	const found = skinClass(look);
	return { ...SKIN, group: "berries", text: found.words, found };
}

/** Lists the numbers of missing berries by reason. */
function missingList({ thinned }: BunchPlant): unknown {
	const reasons = THINNED_WHY.map((why) => ({ why, count: thinned.filter((each) => each.why === why).length }));
	const present = reasons.filter(({ count }) => count > 0);
	if (present.length === 0) return nothing;
	return html`<h3>${text("missing")}</h3>
		<ul class="missing">${present.map(({ why, count }) => html`<li data-why=${why}>${missingFor(why, count)}</li>`)}</ul>`;
}

/** Rounds to tenths. */
const roundedToTenths = (value: number) => Math.round(10 * value) / 10;

/**
 * Draws a plan as a table.
 * @param scale millimetres per pixel of the outline
 */
function planTable(plan: Plan, caption: string, scale: number): unknown {
	return html`<table>
		<caption>${caption}</caption>
		<thead><tr><td></td><th scope="col" title=${text("plan_w")}><i class="symbol">w</i></th><th scope="col" title=${text("plan_r")}><i class="symbol">r</i></th>
			<th scope="col" title=${text("plan_n")}><i class="symbol">n</i></th><th scope="col" title=${text("plan_rd")}><i class="symbol">rd</i></th></tr></thead>
		<tbody>${plan.sides.map(
			({ w, r, n, rd }, side) =>
				html`<tr><th scope="row">${text(SIDES[side][0])} ${symbol(SIDES[side][1])}</th><td>${formatNumber(roundedToTenths(w * scale))}</td><td>${formatNumber(roundedToTenths(r * scale))}</td><td>${n}</td><td>${rd}</td></tr>`,
		)}</tbody>
	</table>`;
}
