import { html } from "lit";
import { SEED } from "../../specimen/limits";
import type { Studio } from "../studio";
import { icon } from "./icons";
import { StudioElement } from "./studio_element";

/** The seed, and a button for another one. */
export class Variation extends StudioElement {
	protected override draw(studio: Studio): unknown {
		return html`<label for="seed">Seed</label>
			<input
				class="seed-field" id="seed" type="text" inputmode="numeric" autocomplete="off"
				.value=${String(studio.state.specimen.seed)} @change=${this.#type}
				title="The same seed gives the same bunch: 0 … ${SEED.max}"
			>
			<button class="button" type="button" title="Another bunch of the same shape (N)" @click=${() => studio.newVariation()}>
				${icon("again")}New variation
			</button>`;
	}

	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const text = field.value.trim();
		const typed = text === "" ? Number.NaN : Number(text);
		const { seed } = this.studio.state.specimen;
		if (Number.isFinite(typed)) this.studio.set({ seed: Math.min(Math.max(Math.round(typed), SEED.min), SEED.max) });
		const taken = this.studio.state.specimen.seed;
		if (!Number.isFinite(typed)) this.studio.notify(`“${text.slice(0, 20)}” is not a seed`, [`Seed ${seed} stays.`]);
		else if (taken !== typed)
			this.studio.notify("That seed is out of range", [
				`Seeds are whole numbers from 0 to ${SEED.max}; ${taken} is used.`,
			]);
		field.value = String(taken);
	}
}

customElements.define("panicle-variation", Variation);
