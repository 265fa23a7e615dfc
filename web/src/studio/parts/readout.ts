import { html, nothing } from "lit";
import { measured } from "../../controls/measured";
import { term } from "../../controls/term";
import type { StudioState } from "../studio_state";
import { VERSION } from "../version";

/** The numbers of the plant on screen: what was measured, the model's own, and its marks. */
export function readout({ grown, measures, model, face, specimen }: StudioState): unknown {
	if (!grown) return html`<p>Nothing has grown yet.</p>`;
	const { timings, fingerprint, notes } = grown;
	const stale = grown.measures === undefined;
	return html`<div class="readout">
		${measures && measures.length > 0 ? html`<div class=${stale ? "stale" : ""} aria-busy=${stale}>${measured(model.table, measures, face?.rows?.(specimen))}</div>` : nothing}
		${face?.readout ? face.readout(grown, specimen) : counts(grown.counts)}
		<h3>This ${model.noun}</h3>
		<dl class="made">
			${term("Grown in", `${timings.grow.toFixed(timings.grow < 10 ? 1 : 0)} ms`)} ${term("Version", VERSION)}
			<dt>Fingerprint</dt><dd class="fingerprint" data-fingerprint>${fingerprint}</dd>
		</dl>
		${notes.length > 0 ? html`<ul class="notes">${notes.map((note) => html`<li>${note}</li>`)}</ul>` : nothing}
	</div>`;
}

/** "endStructures", "end_structures" → "End structures". */
export function inWords(key: string): string {
	const words = key.replaceAll("_", " ").replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
	return words.charAt(0).toUpperCase() + words.slice(1);
}

/** What there is of a model without words of its own. */
function counts(numbers: Readonly<Record<string, number>>): unknown {
	return html`<h3>Counts</h3>
		<dl>${Object.entries(numbers).map(([key, value]) => term(inWords(key), value))}</dl>`;
}
