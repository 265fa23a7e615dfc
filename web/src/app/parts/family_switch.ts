import { html, nothing, type TemplateResult } from "lit";
import { modelNamed } from "../../models/index";
import type { Family } from "../../specimen/presets";
import { icon } from "../../ui/icons";
import { families, firstOf } from "../home/families";
import { text } from "../messages.generated";
import { familyOf } from "../preset_cards";
import type { Studio } from "../studio";
import { isAltered } from "../title";
import { fetchFailed } from "../types";
import { BROWSE } from "./late_parts";
import { openPart } from "./open_part";
import { StudioPart } from "./studio_part";

/** The family and the preset of the plant: a list of the families, and a button that opens the gallery. */
export class FamilySwitch extends StudioPart {
	/** Returns the values whose change redraws the switch. */
	protected override shows({ state: { specimen, model, modelUi } }: Studio): readonly unknown[] {
		return [specimen, model, modelUi];
	}

	/** Renders the list of families, and a button with the preset's title. */
	protected override draw(studio: Studio): unknown {
		const { model, specimen, modelUi } = studio.state;
		const family = familyOf(model, specimen);
		const title = model.presets.named(specimen.preset)?.title ?? model.title;
		return html`${familyList(studio, family)}
			<button
				class="button quiet preset-button" type="button" aria-haspopup="dialog" title=${text("browse_title")}
				@click=${() => openPart(studio, BROWSE)}
			><span>${title}</span>${icon("unfold")}</button>
			${isAltered(specimen, model, modelUi?.tools) ? html`<span class="edited">${text("edited")}</span>` : nothing}`;
	}
}

/** Renders the list of the families, in which the family of the plant is chosen. */
export function familyList(studio: Studio, family: Family): TemplateResult {
	return html`<select
		class="family-list" aria-label=${text("family")} .value=${family}
		@change=${(event: Event) => void choose(studio, (event.target as HTMLSelectElement).value as Family)}
	>${families().map(({ key, title }) => html`<option value=${key} ?selected=${key === family}>${title}</option>`)}</select>`;
}

/** Grows the plant that a family opens with, as one undo step. */
async function choose(studio: Studio, family: Family): Promise<void> {
	const { model, preset } = firstOf(family);
	try {
		studio.choosePreset(preset, await modelNamed(model));
	} catch {
		studio.notify(text("family_failed"), fetchFailed(), { again: () => void choose(studio, family) });
	}
}

customElements.define("panicle-family", FamilySwitch);
