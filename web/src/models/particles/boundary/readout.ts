import { html } from "lit";
import { term } from "../../../ui/term";
import { text } from "../messages.generated";
import type { TrailPlant } from "../trails";

/**
 * Renders the counts of the particle system, named as in the paper (Rodkaew et al. 2003, section 2), after any notes.
 */
export function readout({ counts, notes }: TrailPlant): unknown {
	return html`${notes.length > 0 ? html`<ul class="missing">${notes.map((note) => html`<li>${note}</li>`)}</ul>` : ""}
		<h3>${text("particles")}</h3>
		<dl>
			${term(text("particles"), counts.particles, "N")} ${term(text("merges"), counts.merges)} ${term(text("steps"), counts.steps)}
			${term(text("segments"), counts.segments)} ${term(text("targets"), counts.targets)}
		</dl>`;
}
