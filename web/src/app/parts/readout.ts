import { html, nothing } from "lit";
import { guard } from "lit/directives/guard.js";
import { allBut } from "../../specimen/all_but";
import type { MeasureInfo } from "../../specimen/measures";
import { measured } from "../../ui/measured";
import { term } from "../../ui/term";
import { withThousands } from "../../ui/thousands";
import { runningBy } from "../panel_groups";
import type { Studio } from "../studio";
import type { StudioState } from "../studio_state";
import { TRY_AGAIN } from "../types";
import { VERSION } from "../version";
import { StudioPart } from "./studio_part";
import type { TargetForm } from "./target_form";

/** The numbers of the plant in view: measures, the model's own, growth time, version and fingerprint. */
export class Readout extends StudioPart {
	/** The measure that a click on its number has unfolded: the field below gets the focus. */
	#pressed: Element | undefined;

	protected override shows({ state }: Studio): readonly unknown[] {
		return [state.grown, ...measuredFrom(state)];
	}

	protected override draw(studio: Studio): unknown {
		const { state } = studio;
		const { grown, measures, model, modelUi, specimen } = state;
		if (!grown) return html`<div class="readout"><p>Nothing has grown yet.</p></div>`;
		const { timings, fingerprint, notes } = grown;
		const stale = grown.measures === undefined;
		const searchable = model.targets?.measures(specimen) ?? [];
		const targetForm = (info: MeasureInfo, value: number) =>
			searchable.includes(info.key)
				? html`<panicle-ask .context=${studio} .info=${info} .value=${value}></panicle-ask>`
				: undefined;
		const rows = () => measured(model.table, measures ?? NONE, modelUi?.rows?.(specimen), targetForm);
		return html`<div class="readout" @click=${this.#press} @toggle=${this.#unfold}>
			${measures && measures.length > 0 ? html`<div class=${stale ? "stale" : ""} aria-busy=${stale}>${guard([...measuredFrom(state)], rows)}</div>` : nothing}
			${modelUi?.readout ? modelUi.readout(grown, specimen) : counts(grown.counts)}
			<h3>This ${model.noun}</h3>
			<dl class="made">
				${term("Grown in", `${timings.grow.toFixed(timings.grow < 10 ? 1 : 0)} ms`)} ${term("Version", model.preview ? `${VERSION}, preview` : VERSION)}
				<dt>Fingerprint</dt><dd class="fingerprint" data-fingerprint>${fingerprint}</dd>
			</dl>
			${notes.length > 0 ? notesInWords(notes) : nothing}
		</div>`;
	}

	#press(event: Event): void {
		this.#pressed = (event.target as Element).closest(".askable")?.closest("details") ?? undefined;
	}

	/** Loads the form for requested values when a measure is first unfolded. */
	readonly #unfold = {
		capture: true,
		handleEvent: async ({ target }: Event): Promise<void> => {
			const details = target as HTMLDetailsElement;
			const field = details.open ? details.querySelector<TargetForm>("panicle-ask") : null;
			if (!field) return;
			await import("./target_form").catch(() => {
				this.context.notify("What asks for numbers could not be fetched", [TRY_AGAIN], { topic: "asked" });
			});
			if (details === this.#pressed) void field.enter?.();
		},
	};
}

const NONE = new Float32Array(0);
/** Greatest number of notes shown: layout of thousands of lines takes seconds. */
const MOST_NOTES = 50;

function notesInWords(notes: readonly string[]): unknown {
	const more = notes.length - MOST_NOTES;
	return html`<ul class="notes">
		${notes.slice(0, MOST_NOTES).map((note) => html`<li>${withThousands(note)}</li>`)}
		${more > 0 ? html`<li>And ${more.toLocaleString("en-GB")} more.</li>` : nothing}
	</ul>`;
}

/** The state that the measures depend on; unchanged while a life plays. */
function measuredFrom({ measures, model, modelUi, specimen }: StudioState): readonly unknown[] {
	return [measures, model, modelUi, ...allBut(specimen, runningBy(modelUi?.tools))];
}

/** "endStructures", "end_structures" → "End structures". */
export function inWords(key: string): string {
	const words = key.replaceAll("_", " ").replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
	return words.charAt(0).toUpperCase() + words.slice(1);
}

/** The counts of a model without a read-out of its own. */
function counts(numbers: Readonly<Record<string, number>>): unknown {
	return html`<h3>Counts</h3>
		<dl>${Object.entries(numbers).map(([key, value]) => term(inWords(key), value.toLocaleString("en-GB")))}</dl>`;
}

customElements.define("panicle-readout", Readout);
