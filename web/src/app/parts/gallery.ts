import { html, nothing, type PropertyValues } from "lit";
import { repeat } from "lit/directives/repeat.js";
import type { PageModel } from "../../models/page_model";
import type { Preset } from "../../specimen/presets";
import { icon } from "../../ui/icons";
import { rove, stopAt } from "../../ui/roving";
import { findPresets, kindKey, type PresetSection, sectionsOf } from "../preset_search";
import type { Studio } from "../studio";
import { SAVED } from "./late_parts";
import { openPart } from "./open_part";
import { StudioPart } from "./studio_part";

/** Address of a preset's picture, rendered by the app for each theme (`npm run pictures -- gallery`). */
const pictureOf = (model: PageModel, { name }: Preset, dark: boolean) =>
	`${import.meta.env.BASE_URL}gallery/${model.name}/${name}-${dark ? "dark" : "light"}.webp`;

const picture = (src: string) =>
	html`<img src=${src} alt="" width="60" height="75" loading="lazy" fetchpriority="low" decoding="async">`;

/**
 * The presets of every model as small pictures, by kind, with a search and a filter; choosing one is one undo step. The strip is one
 * stop of the Tab key: arrow keys move between presets.
 */
export class Gallery extends StudioPart {
	#query = "";
	/** Key of the kind shown; empty for all. */
	#kind = "";
	/** The preset last scrolled into view, with the number of models then. */
	#revealed: string | undefined;

	protected override shows({ state: { catalogue, dark, specimen } }: Studio): readonly unknown[] {
		return [catalogue, dark, specimen.model, specimen.preset];
	}

	protected override draw(studio: Studio): unknown {
		const { catalogue } = studio.state;
		const sections = sectionsOf(catalogue);
		const found = findPresets(sections, this.#query, this.#kind);
		return html`<div class="find" role="search" aria-label="Presets" @keydown=${this.#findKey}>
				<button
					class="button" type="button" aria-label="Saved…" title="Save this ${studio.state.model.noun}, and what you have saved (Ctrl+S)"
					@click=${() => openPart(studio, SAVED)}
				>${icon("saved")}<span class="words">Saved…</span></button>
				<input
					type="search" aria-label="Search presets" placeholder="Search presets" autocomplete="off" spellcheck="false"
					.value=${this.#query} @input=${(event: Event) => this.#look({ query: (event.target as HTMLInputElement).value })}
				>
				<select
					aria-label="Kind of preset" .value=${this.#kind}
					@change=${(event: Event) => this.#look({ kind: (event.target as HTMLSelectElement).value })}
				>
					<option value="">All kinds</option>
					${catalogue.map((model) => this.#kinds(model, sections, catalogue.length > 1))}
				</select>
				<p class="found" role="status">${inWords(found)}</p>
			</div>
			<div class="strip" @keydown=${this.#stripKey}>
				${repeat(found, kindKey, (section) => this.#section(studio, section, catalogue.length > 1))}
				${
					found.length === 0
						? html`<p class="none">No preset has that in its name or description.
							<button class="button" type="button" @click=${this.#clear}>Show all</button></p>`
						: nothing
				}
			</div>`;
	}

	#kinds(model: PageModel, sections: readonly PresetSection[], many: boolean): unknown {
		const options = sections
			.filter((section) => section.model === model)
			.map((section) => {
				const key = kindKey(section);
				return html`<option value=${key} ?selected=${key === this.#kind}>${section.kind.title}</option>`;
			});
		return many ? html`<optgroup label=${model.shelf ?? model.title}>${options}</optgroup>` : options;
	}

	#section(studio: Studio, section: PresetSection, many: boolean): unknown {
		const { model, kind, presets } = section;
		const id = this.idOf(`kind-${kindKey(section).replace(" ", "-")}`);
		return html`<section aria-labelledby=${id} data-model=${model.name}>
			<h2 id=${id}>${many ? html`<b>${model.shelf ?? model.title}</b> ${model.preview ? html`<small>preview</small> ` : nothing}` : nothing}${kind.title}</h2>
			<ul>${repeat(
				presets,
				({ name }) => name,
				(preset) => this.#item(studio, model, preset),
			)}</ul>
		</section>`;
	}

	#item(studio: Studio, model: PageModel, preset: Preset): unknown {
		const { specimen, dark } = studio.state;
		const chosen = model.name === specimen.model && preset.name === specimen.preset;
		return html`<li>
			<button
				class="preset" type="button" aria-current=${chosen} title=${described(preset)} data-preset=${preset.name} tabindex="-1"
				@click=${() => studio.choosePreset(preset.name, model)}
			>
				${model.pictures === false ? html`<span class="no-picture"></span>` : picture(pictureOf(model, preset, dark))}${preset.title}
				${preset.figure === undefined ? nothing : html`<small aria-hidden="true">Fig. ${preset.figure}</small>`}
			</button>
		</li>`;
	}

	/** Scrolls the chosen preset into view, also when a link or a file has chosen it. */
	protected override updated(_changed: PropertyValues): void {
		const { specimen, catalogue } = this.context.state;
		const wanted = `${catalogue.length} ${specimen.model} ${specimen.preset}`;
		const strip = this.querySelector<HTMLElement>(".strip");
		const chosen = this.querySelector<HTMLElement>("[aria-current=true]");
		const items = this.#items();
		stopAt(items, items.find((item) => item === document.activeElement) ?? chosen ?? items[0]);
		if (this.#revealed === wanted || !strip || !chosen) return;
		this.#revealed = wanted;
		reveal(strip, chosen);
	}

	#look({ query = this.#query, kind = this.#kind }: { query?: string; kind?: string }): void {
		this.#query = query;
		this.#kind = kind;
		this.#revealed = undefined;
		const strip = this.querySelector(".strip");
		if (strip) strip.scrollLeft = 0;
		this.requestUpdate();
	}

	readonly #clear = (): void => {
		this.#look({ query: "", kind: "" });
		this.querySelector<HTMLElement>("input[type=search]")?.focus();
	};

	#findKey(event: KeyboardEvent): void {
		const field = event.target as HTMLElement;
		if (event.key === "Escape" && (this.#query !== "" || this.#kind !== "")) {
			event.preventDefault();
			this.#clear();
		} else if (field instanceof HTMLInputElement && (event.key === "ArrowDown" || event.key === "Enter")) {
			event.preventDefault();
			const [first] = this.#items();
			if (event.key === "ArrowDown") first?.focus();
			else if (this.#query !== "") first?.click();
		}
	}

	#stripKey(event: KeyboardEvent): void {
		if (event.key === "Escape") {
			event.preventDefault();
			this.querySelector<HTMLElement>("input[type=search]")?.focus();
		} else rove(event, this.#items());
	}

	#items(): HTMLElement[] {
		return [...this.querySelectorAll<HTMLElement>(".preset")];
	}
}

/** "31 presets". */
function inWords(sections: readonly PresetSection[]): string {
	const count = sections.reduce((sum, { presets }) => sum + presets.length, 0);
	if (count === 0) return "No preset found";
	return count === 1 ? "1 preset" : `${count} presets`;
}

function described({ about, figure }: Preset): string {
	return figure === undefined ? about : `${about} (figure ${figure})`;
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
