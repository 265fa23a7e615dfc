import { html } from "lit";
import { SEED } from "../../specimen/limits";
import { icon } from "../../ui/icons";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** The seed field, and the button for a random seed. */
export class Variation extends StudioPart {
	protected override shows({ state: { specimen, model } }: Studio): readonly unknown[] {
		return [specimen.seed, model];
	}

	protected override draw(studio: Studio): unknown {
		const { specimen, model } = studio.state;
		return html`<label for=${this.idOf("seed")}>Seed</label>
			<input
				class="seed-field" id=${this.idOf("seed")} type="text" inputmode="numeric" autocomplete="off"
				.value=${String(specimen.seed)} @change=${this.#type}
				title="The same seed gives the same ${model.noun}: 0 … ${SEED.max}"
			>
			<button class="button" type="button" title="Another ${model.noun} of the same shape (N)" @click=${() => studio.newVariation()}>
				${icon("again")}New variation
			</button>`;
	}

	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const text = field.value.trim();
		const typed = text === "" ? Number.NaN : Number(text);
		const { seed } = this.context.state.specimen;
		if (Number.isFinite(typed)) this.context.set({ seed: Math.min(Math.max(Math.round(typed), SEED.min), SEED.max) });
		const taken = this.context.state.specimen.seed;
		if (!Number.isFinite(typed)) this.context.notify(`“${text.slice(0, 20)}” is not a seed`, [`Seed ${seed} stays.`]);
		else if (taken !== typed)
			this.context.notify("That seed is out of range", [
				`Seeds are whole numbers from 0 to ${SEED.max}; ${taken} is used.`,
			]);
		field.value = String(taken);
	}
}

customElements.define("panicle-variation", Variation);
