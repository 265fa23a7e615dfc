import { html, nothing, type PropertyValues } from "lit";
import { repeat } from "lit/directives/repeat.js";
import type { PageModel } from "../../models/page_model";
import type { Preset } from "../../specimen/presets";
import { icon } from "../../ui/icons";
import { rove, stopAt } from "../../ui/roving";
import { familyTitle } from "../home/families";
import { text } from "../messages.generated";
import { cardContent, described, familyOf, kindOf, modelsOf, sectionsOfFamily } from "../preset_cards";
import { kindKey, type PresetSection, sectionsOf } from "../preset_sections";
import type { Studio } from "../studio";
import { familyList } from "./family_switch";
import { BROWSE, SAVED } from "./late_parts";
import { openPart } from "./open_part";
import { StudioPart } from "./studio_part";

/**
 * The presets of the shown plant's family as a strip of small pictures; choosing one is one undo step. Presets that
 * reproduce figures of papers are left out, except next to one that is shown. The strip is one stop of the Tab key:
 * arrow keys move between presets.
 */
export class Gallery extends StudioPart {
	/** The name of the model whose presets are shown; empty for all of the family. */
	#method = "";
	/** The preset last scrolled into view, with the number of models then. */
	#revealed: string | undefined;

	/** Returns the values whose change redraws the strip. */
	protected override shows({ state: { catalogue, dark, specimen } }: Studio): readonly unknown[] {
		return [catalogue, dark, specimen.model, specimen.preset];
	}

	/** Renders the buttons, the filter, and the strip of presets. */
	protected override draw(studio: Studio): unknown {
		const { catalogue, model, specimen } = studio.state;
		const family = familyOf(model, specimen);
		const own = kindOf(model, specimen);
		const all = sectionsOfFamily(sectionsOf(catalogue), family);
		const methods = modelsOf(all);
		const isListed = (section: PresetSection) =>
			(!section.kind.fromPaper || section.kind === own) && (this.#method === "" || section.model.name === this.#method);
		if (this.#method !== "" && !methods.some(({ name }) => name === this.#method)) this.#method = "";
		return html`<h2 class="unseen">${text("page_presets")}</h2>
			<div class="find">
				<span class="phone-only">${familyList(studio, family)}</span>
				<button class="button" type="button" title=${text("browse_title")} @click=${() => openPart(studio, BROWSE)}>
					${icon("search")}<span class="words">${text("browse")}</span>
				</button>
				<button
					class="button" type="button" aria-label=${text("saved")} title=${text("saved_title")}
					@click=${() => openPart(studio, SAVED)}
				>${icon("saved")}<span class="words">${text("saved")}</span></button>
				${methods.length > 1 ? this.#methods(methods) : nothing}
			</div>
			<div class="strip" role="group" @keydown=${this.#stripKey} aria-label=${familyTitle(family)} @wheel=${scrollSideways}>
				${repeat(all.filter(isListed), kindKey, (section) => this.#section(studio, section))}
			</div>`;
	}

	/** Renders the filter by method, for families that several models grow. */
	#methods(methods: readonly PageModel[]): unknown {
		return html`<select
			class="method-list" aria-label=${text("gallery_method")} .value=${this.#method}
			@change=${(event: Event) => {
				this.#method = (event.target as HTMLSelectElement).value;
				this.requestUpdate();
			}}
		>
			<option value="">${text("gallery_all_methods")}</option>
			${methods.map(({ name, shelf, title }) => html`<option value=${name} ?selected=${name === this.#method}>${shelf ?? title}</option>`)}
		</select>`;
	}

	/** Renders a section: its title and the list of its presets. */
	#section(studio: Studio, section: PresetSection): unknown {
		const { model, kind, presets } = section;
		const id = this.idOf(`kind-${kindKey(section).replace(" ", "-")}`);
		return html`<section role="group" aria-labelledby=${id} data-model=${model.name}>
			<h3 id=${id}>${kind.title}</h3>
			<ul>${repeat(
				presets,
				({ name }) => name,
				(preset) => this.#item(studio, model, preset),
			)}</ul>
		</section>`;
	}

	/** Renders a preset as a button. */
	#item(studio: Studio, model: PageModel, preset: Preset): unknown {
		const { specimen, dark } = studio.state;
		const chosen = model.name === specimen.model && preset.name === specimen.preset;
		return html`<li>
			<button
				class="preset" type="button" aria-current=${chosen} title=${described(preset)} data-preset=${preset.name} tabindex="-1"
				@click=${() => studio.choosePreset(preset.name, model)}
			>${cardContent(model, preset, dark)}</button>
		</li>`;
	}

	/** Scrolls the chosen preset into view, also when a link or a file has chosen it. */
	protected override updated(_changed: PropertyValues): void {
		const { specimen, catalogue } = this.context.state;
		this.dataset.models = `${catalogue.length}`;
		const wanted = `${catalogue.length} ${specimen.model} ${specimen.preset}`;
		const strip = this.querySelector<HTMLElement>(".strip");
		const chosen = this.querySelector<HTMLElement>("[aria-current=true]");
		const items = this.#items();
		stopAt(items, items.find((item) => item === document.activeElement) ?? chosen ?? items[0]);
		if (this.#revealed === wanted || !strip || !chosen) return;
		this.#revealed = wanted;
		reveal(strip, chosen);
	}

	/** Moves the focus among the presets by a key; Escape leaves the strip. */
	#stripKey(event: KeyboardEvent): void {
		if (event.key === "Escape") {
			event.preventDefault();
			this.querySelector<HTMLElement>(".find button")?.focus();
		} else rove(event, this.#items());
	}

	/** Returns the presets' buttons. */
	#items(): HTMLElement[] {
		return [...this.querySelectorAll<HTMLElement>(".preset")];
	}
}

/** Scrolls the strip sideways with a wheel that turns up and down; at an end of the strip the page gets the wheel. */
function scrollSideways(event: WheelEvent): void {
	if (event.ctrlKey || Math.abs(event.deltaY) <= Math.abs(event.deltaX)) return;
	const strip = event.currentTarget as HTMLElement;
	const before = strip.scrollLeft;
	const direction = getComputedStyle(strip).direction === "rtl" ? -1 : 1;
	strip.scrollLeft += direction * event.deltaY;
	if (strip.scrollLeft !== before) event.preventDefault();
}

/** Visible part of a neighbour, which shows that the strip goes on; CSS pixels. */
const NEIGHBOUR = 48;

/** Scrolls the strip alone until the preset is well in view. */
function reveal(strip: HTMLElement, preset: HTMLElement): void {
	const box = preset.getBoundingClientRect();
	const shown = strip.getBoundingClientRect();
	const [left, right] = [box.left - NEIGHBOUR - shown.left, box.right + NEIGHBOUR - shown.right];
	if (left < 0) strip.scrollLeft += left;
	else if (right > 0) strip.scrollLeft += right;
}

customElements.define("panicle-gallery", Gallery);
