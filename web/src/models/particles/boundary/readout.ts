import { html } from "lit";
import { term } from "../../../ui/term";
import type { TrailPlant } from "../trails";

/** Counts of the particle system, named as in the paper (Rodkaew et al. 2003, section 2). */
export function readout({ counts, notes }: TrailPlant): unknown {
	return html`${notes.length > 0 ? html`<ul class="missing">${notes.map((note) => html`<li>${note}</li>`)}</ul>` : ""}
		<h3>Particles</h3>
		<dl>
			${term("Particles", counts.particles, "N")} ${term("Merges", counts.merges)} ${term("Steps", counts.steps)}
			${term("Segments", counts.segments)} ${term("Targets", counts.targets)}
		</dl>`;
}
