import { html, nothing } from "lit";
import { guard } from "lit/directives/guard.js";
import { formatNumber } from "../../locale/format";
import type { Plant } from "../../plant/plant";
import { isOnText } from "../../plant/text_notes";
import { allBut } from "../../specimen/all_but";
import type { WithGrammar } from "../../specimen/grammar_text";
import type { MeasureInfo } from "../../specimen/measures";
import type { Specimen } from "../../specimen/specimen";
import { measured } from "../../ui/measured";
import { term } from "../../ui/term";
import { withThousands } from "../../ui/thousands";
import { text } from "../messages.generated";
import { runningBy } from "../panel_groups";
import type { Studio } from "../studio";
import type { StudioState } from "../studio_state";
import { fetchFailed } from "../types";
import { VERSION } from "../version";
import { StudioPart } from "./studio_part";
import type { TargetForm } from "./target_form";

/** The numbers of the plant in view: measures, the model's own, growth time, version and fingerprint. */
export class Readout extends StudioPart {
	/** The measure that a click on its number has unfolded: the field below gets the focus. */
	#pressed: Element | undefined;

	/** Returns the values whose change redraws the numbers. */
	protected override shows({ state }: Studio): readonly unknown[] {
		return [state.grown, ...measuredFrom(state)];
	}

	/** Renders measures, counts, time, version, source, fingerprint and notes of the grown plant. */
	protected override draw(studio: Studio): unknown {
		const { state } = studio;
		const { grown, grownFrom, measures, model, modelUi, specimen } = state;
		if (!grown) return html`<div class="readout"><p>${text("growing_nothing")}</p></div>`;
		const { timings, fingerprint } = grown;
		const notes = shownNotes(grown, grownFrom);
		const source = specimen.preset === undefined ? undefined : model.presets.named(specimen.preset)?.source;
		const stale = grown.measures === undefined;
		const searchable = model.targets?.measures(specimen) ?? [];
		const targetForm = (info: MeasureInfo, value: number) =>
			searchable.includes(info.key)
				? html`<panicle-ask .context=${studio} .info=${info} .value=${value}></panicle-ask>`
				: undefined;
		const rows = () => measured(model.table, measures ?? NONE, modelUi?.rows?.(specimen), targetForm);
		return html`<div class="readout" @click=${this.#recordPressed} @toggle=${this.#unfold}>
			${measures && measures.length > 0 ? html`<div class=${stale ? "stale" : ""} aria-busy=${stale}>${guard([...measuredFrom(state)], rows)}</div>` : nothing}
			${modelUi?.readout ? modelUi.readout(grown, specimen) : counts(grown.counts)}
			<h3>${text("readout_plant")}</h3>
			<dl class="made">
				${term(text("readout_time"), timeInWords(timings.grow))} ${term(text("readout_version"), model.preview ? text("readout_version_preview", { version: VERSION }) : VERSION)}
				${source ? term(text("readout_source"), source) : nothing}
				<dt>${text("readout_fingerprint")}</dt><dd class="fingerprint" data-fingerprint>${fingerprint}</dd>
			</dl>
			${notes.length > 0 ? notesInWords(notes) : nothing}
		</div>`;
	}

	/** Records which measure a click unfolds. */
	#recordPressed(event: Event): void {
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
				this.context.notify(text("target_failed"), fetchFailed(), { topic: "asked" });
			});
			if (details === this.#pressed) void field.enter?.();
		},
	};
}

/** Describes a time in milliseconds, with a decimal below 10. */
const timeInWords = (time: number): string =>
	text("readout_milliseconds", { time: formatNumber(time, { maximumFractionDigits: time < 10 ? 1 : 0 }) });

/**
 * Returns the notes on a plant. Those on lines of a preset's text are left out: the grammar pane shows them beside the
 * lines, and a user who has not opened it knows of no lines.
 */
export function shownNotes(
	{ notes, noteMessages = [] }: Pick<Plant, "notes" | "noteMessages">,
	from: (Specimen & Partial<WithGrammar>) | undefined,
): readonly string[] {
	if (from?.grammar !== undefined) return notes;
	const onText = new Set(noteMessages.filter(isOnText).map((note) => note.text));
	return notes.filter((note) => !onText.has(note));
}

const NONE = new Float32Array(0);
/** Greatest number of notes shown: layout of thousands of lines takes seconds. */
const MAX_NOTES = 50;

/** Renders at most MAX_NOTES notes, and the number of further ones. */
function notesInWords(notes: readonly string[]): unknown {
	const more = notes.length - MAX_NOTES;
	return html`<ul class="notes">
		${notes.slice(0, MAX_NOTES).map((note) => html`<li>${withThousands(note)}</li>`)}
		${more > 0 ? html`<li>${text("readout_more", { count: more })}</li>` : nothing}
	</ul>`;
}

/** Returns the state that the measures depend on; unchanged while a life plays. */
function measuredFrom({ measures, model, modelUi, specimen }: StudioState): readonly unknown[] {
	return [measures, model, modelUi, ...allBut(specimen, runningBy(modelUi?.tools))];
}

/** Converts a key to words: "endStructures", "end_structures" → "End structures". */
export function inWords(key: string): string {
	const words = key.replaceAll("_", " ").replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
	return words.charAt(0).toUpperCase() + words.slice(1);
}

/** Renders the counts of a model without a read-out of its own. */
function counts(numbers: Readonly<Record<string, number>>): unknown {
	return html`<h3>${text("readout_counts")}</h3>
		<dl>${Object.entries(numbers).map(([key, value]) => term(inWords(key), formatNumber(value)))}</dl>`;
}

customElements.define("panicle-readout", Readout);
