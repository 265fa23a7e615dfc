import { html } from "lit";
import { SEED } from "../../specimen/limits";
import { icon } from "../../ui/icons";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** The seed field, and the button for a random seed. */
export class Variation extends StudioPart {
	/** Returns the values whose change redraws the field. */
	protected override shows({ state: { specimen } }: Studio): readonly unknown[] {
		return [specimen.seed];
	}

	/** Renders the seed and a button for another one. */
	protected override draw(studio: Studio): unknown {
		const { specimen } = studio.state;
		return html`<label for=${this.idOf("seed")}>${text("seed")}</label>
			<input
				class="seed-field" id=${this.idOf("seed")} type="text" inputmode="numeric" autocomplete="off"
				.value=${String(specimen.seed)} @change=${this.#type}
				title=${text("seed_title")}
			>
			<button class="button" type="button" title=${text("variation_new_title")} @click=${() => studio.newVariation()}>
				${icon("again")}<span class="variation-words">${text("variation_new")}</span>
			</button>`;
	}

	/** Sets the typed seed, rounded and within its limits; notifies if that changed it, or if it is no number. */
	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const written = field.value.trim();
		const typed = written === "" ? Number.NaN : Number(written);
		const { seed } = this.context.state.specimen;
		if (Number.isFinite(typed)) this.context.set({ seed: Math.min(Math.max(Math.round(typed), SEED.min), SEED.max) });
		const taken = this.context.state.specimen.seed;
		if (!Number.isFinite(typed)) {
			const title = text("seed_not_whole", { typed: written.slice(0, 20) });
			this.context.notify(title, [text("seed_unchanged", { seed: `${seed}` })]);
		} else if (taken !== typed) {
			const title = text("seed_out_of_range", { least: SEED.min, most: SEED.max });
			this.context.notify(title, [text("seed_used", { seed: taken })]);
		}
		field.value = String(taken);
	}
}

customElements.define("panicle-variation", Variation);
