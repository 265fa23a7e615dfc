import { html, nothing } from "lit";
import { type Grown, type Plan, THINNED_WHY } from "../../models/bunch/grown";
import type { StudioState } from "../studio";
import { VERSION } from "../version";
import { measured } from "./measures";
import { symbol } from "./symbol";

const SIDES = [
	["Right", "p₃"],
	["Left", "p₄"],
	["Front", "p₅"],
	["Back", "p₆"],
] as const;

/** Why a berry is not there, for many and for one. */
const WHY: Readonly<Record<(typeof THINNED_WHY)[number], readonly [many: string, one: string]>> = {
	"": ["for no reason told", "for no reason told"],
	"not set": ["flowers that set no berry", "flower that set no berry"],
	"no room": ["found no room to swell", "found no room to swell"],
	outside: ["would have grown outside the outline", "would have grown outside the outline"],
	"by hand": ["taken off by hand", "taken off by hand"],
};

/** The numbers of the bunch on screen: what a viticulturist reads, what is not there and why, the paper's own, its marks. */
export function readout({ grown, measures, specimen }: StudioState): unknown {
	if (!grown) return html`<p>Nothing has grown yet.</p>`;
	const { counts, timings, fingerprint } = grown;
	const stale = grown.measures === undefined;
	return html`<div class="readout">
		${measures && measures.length > 0 ? html`<div class=${stale ? "stale" : ""} aria-busy=${stale}>${measured(measures, specimen.look)}</div>` : nothing}
		${missing(grown)}
		<h3>After the paper</h3>
		<dl>
			${term("Berries", counts.berries)}
			${grown.procedure === "paper" ? term("Withered pedicels", counts.withered) : nothing}
			${term("Pedicels", counts.pedicels)} ${term("Internodes", counts.internodes)}
			${grown.procedure === "paper" ? term("Internodes cut", counts.cut) : nothing}
			${term("Length", `${specimen.parameters.l} px`, "l")} ${term("Rachis segments", grown.plan.m, "m")}
		</dl>
		${planTable(grown.plan, "Each side")} ${grown.second ? planTable(grown.second, `Second bunch, m ${grown.second.m}`) : nothing}
		<h3>This bunch</h3>
		<dl class="made">
			${term("Grown in", `${timings.grow.toFixed(timings.grow < 10 ? 1 : 0)} ms`)} ${term("Version", VERSION)}
			<dt>Fingerprint</dt><dd class="fingerprint" data-fingerprint>${fingerprint}</dd>
		</dl>
		${grown.notes.length > 0 ? html`<ul class="notes">${grown.notes.map((note) => html`<li>${note}</li>`)}</ul>` : nothing}
	</div>`;
}

function term(words: string, value: unknown, sign = ""): unknown {
	return html`<dt>${words}${symbol(sign)}</dt><dd>${value}</dd>`;
}

/** How many berries are not there, by reason. */
function missing({ thinned }: Grown): unknown {
	const reasons = THINNED_WHY.map((why) => ({ why, count: thinned.filter((each) => each.why === why).length }));
	const given = reasons.filter(({ count }) => count > 0);
	if (given.length === 0) return nothing;
	return html`<h3>Berries that are not there</h3>
		<ul class="missing">${given.map(({ why, count }) => html`<li data-why=${why}><b>${count}</b> ${WHY[why][count === 1 ? 1 : 0]}</li>`)}</ul>`;
}

function planTable(plan: Plan, caption: string): unknown {
	const round = (value: number) => Math.round(value * 100) / 100;
	return html`<table>
		<caption>${caption}</caption>
		<thead><tr><th></th><th scope="col" title="Half-width, pixels"><i class="symbol">w</i></th><th scope="col" title="Drop, pixels"><i class="symbol">r</i></th>
			<th scope="col" title="Segments of the longest axis"><i class="symbol">n</i></th><th scope="col" title="Axis at which the side has shrunk to one end structure"><i class="symbol">rd</i></th></tr></thead>
		<tbody>${plan.sides.map(
			({ w, r, n, rd }, side) =>
				html`<tr><th scope="row">${SIDES[side][0]} ${symbol(SIDES[side][1])}</th><td>${round(w)}</td><td>${round(r)}</td><td>${n}</td><td>${rd}</td></tr>`,
		)}</tbody>
	</table>`;
}
