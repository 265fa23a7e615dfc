import { html, nothing } from "lit";
import type { Plan } from "../../core/grown";
import type { StudioState } from "../studio";
import { VERSION } from "../version";
import { symbol } from "./symbol";

const SIDES = [
	["Right", "p₃"],
	["Left", "p₄"],
	["Front", "p₅"],
	["Back", "p₆"],
] as const;

/** The numbers of the bunch on screen, with the paper's symbols beside the words. */
export function readout({ grown, specimen }: StudioState): unknown {
	if (!grown) return html`<p>Nothing has grown yet.</p>`;
	const { counts, plan, second, timings, fingerprint } = grown;
	const term = (words: string, value: unknown, sign = "") => html`<dt>${words}${symbol(sign)}</dt><dd>${value}</dd>`;
	return html`<div class="readout">
		<dl>
			${term("Berries", counts.berries)} ${term("Withered pedicels", counts.withered)} ${term("Pedicels", counts.pedicels)}
			${term("Internodes", counts.internodes)} ${term("Internodes cut", counts.cut)}
			${term("Length", `${specimen.parameters.l} px`, "l")} ${term("Rachis segments", plan.m, "m")}
		</dl>
		${planTable(plan, "Each side")} ${second ? planTable(second, `Second bunch, m ${second.m}`) : nothing}
		<dl class="made">
			${term("Grown in", `${timings.grow.toFixed(timings.grow < 10 ? 1 : 0)} ms`)} ${term("Version", VERSION)}
			<dt>Fingerprint</dt><dd class="fingerprint" data-fingerprint>${fingerprint}</dd>
		</dl>
	</div>`;
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
