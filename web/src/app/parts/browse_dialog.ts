import { html, nothing, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import type { PageModel } from "../../models/page_model";
import { FAMILIES, type Family, type Preset } from "../../specimen/presets";
import { icon } from "../../ui/icons";
import { rove, stopAt } from "../../ui/roving";
import { familyTitle } from "../home/families";
import { text } from "../messages.generated";
import { cardContent, described, familyOf, modelsOf, presetKey, sectionsOfFamily } from "../preset_cards";
import { type PlacedPreset, placeInWords, searchPresets } from "../preset_search";
import { kindKey, type PresetSection, sectionsOf } from "../preset_sections";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";
import "../style/browse.css";

/** The presets listed: those of one family, of all, or the user's own choice. */
type Shelf = Family | "all" | "favourites" | "recent";

/**
 * The gallery: a dialog with the presets of all families, a search, filters, favourites and the presets used last.
 * Choosing a preset is one undo step and closes the dialog. The presets are one stop of the Tab key: arrow keys move
 * between them.
 */
export class BrowseDialog extends StudioPart {
	#isOpen = false;
	#query = "";
	#shelf: Shelf = "all";
	/** The name of the model whose presets are shown; empty for all. */
	#method = "";

	/** Returns the values whose change redraws the dialog. */
	protected override shows({ state: { catalogue, dark, specimen, ui } }: Studio): readonly unknown[] {
		return this.#isOpen ? [catalogue, dark, specimen.model, specimen.preset, ui.favourites, ui.recentPresets] : [];
	}

	/** Renders the dialog, empty while it is closed. */
	protected override draw(studio: Studio): unknown {
		return html`<dialog class="help browse" aria-labelledby=${this.idOf("title")} @close=${this.#closed}>
			${this.#isOpen ? this.#body(studio) : nothing}
		</dialog>`;
	}

	/** Opens the dialog with the family of the shown plant, and scrolls to its preset. */
	async open(): Promise<void> {
		const { model, specimen } = this.context.state;
		this.#isOpen = true;
		this.#query = "";
		this.#method = "";
		this.#shelf = familyOf(model, specimen);
		this.requestUpdate();
		await this.updateComplete;
		this.querySelector("dialog")?.showModal();
		this.querySelector("[aria-current=true]")?.scrollIntoView({ block: "center" });
		this.querySelector<HTMLElement>("input[type=search]")?.focus({ preventScroll: true });
	}

	/** Renders the search, the filters and the presets found. */
	#body(studio: Studio): TemplateResult {
		const all = sectionsOf(studio.state.catalogue);
		const query = this.#query.trim();
		const listed = query === "" ? this.#onShelf(studio, all) : all;
		const methods = query === "" && this.#shelf !== "all" ? modelsOf(listed) : [];
		const sections = listed.filter(({ model }) => this.#method === "" || model.name === this.#method);
		const isRanked = query !== "" || this.#shelf === "favourites" || this.#shelf === "recent";
		const placed = query === "" ? placedIn(sections) : searchPresets(sections, query).map(({ entry }) => entry);
		const count = placed.length;
		return html`<header>
				<h2 id=${this.idOf("title")}>${text("browse_heading")}</h2>
				<button class="button quiet icon" type="button" aria-label=${text("close")} title=${text("close")} @click=${this.#close}>${icon("close")}</button>
				<div role="search" aria-label=${text("page_presets")} @keydown=${this.#searchKey}>
					<input
						type="search" aria-label=${text("gallery_search")} placeholder=${text("gallery_search")} autocomplete="off" spellcheck="false"
						.value=${this.#query} @input=${(event: Event) => this.#setFilter({ query: (event.target as HTMLInputElement).value, method: "" })}
					>
					<p class="found" role="status">${text("gallery_found", { count })}</p>
				</div>
				${this.#shelves(studio)}
				${methods.length > 1 ? this.#methods(methods) : nothing}
			</header>
			<div class="browse-list" @keydown=${this.#listKey} @focusin=${(event: Event) => stopAt(this.#items(), event.target as HTMLElement)}>
				${count === 0 ? this.#nothingFound() : isRanked ? this.#ranked(studio, placed) : this.#sections(studio, sections)}
			</div>`;
	}

	/** Renders the chips of families, favourites and recent presets. */
	#shelves({ state: { ui } }: Studio): TemplateResult {
		const chip = (shelf: Shelf, title: string) => html`<button
			class="chip" type="button" aria-pressed=${this.#query === "" && this.#shelf === shelf}
			@click=${() => this.#setFilter({ shelf, query: "", method: "" })}
		>${title}</button>`;
		return html`<div class="chips" role="group" aria-label=${text("gallery_category")}>
			${chip("all", text("browse_all"))}
			${FAMILIES.map((family) => chip(family, familyTitle(family)))}
			${ui.favourites.length > 0 ? chip("favourites", text("browse_favourites")) : nothing}
			${ui.recentPresets.length > 0 ? chip("recent", text("browse_recent")) : nothing}
		</div>`;
	}

	/** Renders the chips of the methods that grow the listed presets. */
	#methods(methods: readonly PageModel[]): TemplateResult {
		const chip = (name: string, title: string) => html`<button
			class="chip" type="button" aria-pressed=${this.#method === name} @click=${() => this.#setFilter({ method: name })}
		>${title}</button>`;
		return html`<div class="chips methods" role="group" aria-label=${text("gallery_method")}>
			${chip("", text("gallery_all_methods"))}${methods.map(({ name, shelf, title }) => chip(name, shelf ?? title))}
		</div>`;
	}

	/** Returns the sections of the chosen shelf; favourites and recent presets are one section in their own order. */
	#onShelf({ state: { ui } }: Studio, all: readonly PresetSection[]): readonly PresetSection[] {
		if (this.#shelf === "all") return all;
		if (this.#shelf !== "favourites" && this.#shelf !== "recent") return sectionsOfFamily(all, this.#shelf);
		const keys = this.#shelf === "favourites" ? ui.favourites : ui.recentPresets;
		return keys.flatMap((key) =>
			all.flatMap((section) => {
				const presets = section.presets.filter((preset) => presetKey(section.model, preset) === key);
				return presets.length > 0 ? [{ ...section, presets }] : [];
			}),
		);
	}

	/** Renders presets as one list: those that a search found, best first, or the user's own list. */
	#ranked(studio: Studio, placed: readonly PlacedPreset[]): TemplateResult {
		return html`<ul class="cards">${repeat(
			placed,
			({ model, preset }) => presetKey(model, preset),
			({ model, kind, preset }) => this.#card(studio, model, preset, placeInWords({ model, kind, preset })),
		)}</ul>`;
	}

	/** Renders the sections; those from papers are folded unless they hold the shown preset. */
	#sections(studio: Studio, found: readonly PresetSection[]): unknown {
		const { specimen } = studio.state;
		const holdsShown = ({ model, presets }: PresetSection) =>
			model.name === specimen.model && presets.some(({ name }) => name === specimen.preset);
		const papers = found.filter(({ kind }) => kind.fromPaper);
		const section = (each: PresetSection) => this.#section(studio, each);
		return html`${repeat(
			found.filter(({ kind }) => !kind.fromPaper),
			kindKey,
			section,
		)}${
			papers.length > 0
				? html`<details class="papers" ?open=${papers.some(holdsShown)}>
					<summary>${text("browse_papers")}</summary>
					${repeat(papers, kindKey, section)}
				</details>`
				: nothing
		}`;
	}

	/** Renders a section: its title and its presets. */
	#section(studio: Studio, section: PresetSection): TemplateResult {
		const { model, kind, presets } = section;
		const id = this.idOf(`kind-${kindKey(section).replace(" ", "-")}`);
		return html`<section aria-labelledby=${id} data-model=${model.name}>
			<h3 id=${id}>${kind.title} <small>${model.shelf ?? model.title}</small></h3>
			<ul class="cards">${repeat(
				presets,
				({ name }) => name,
				(preset) => this.#card(studio, model, preset),
			)}</ul>
		</section>`;
	}

	/**
	 * Renders a preset with the button that makes it a favourite.
	 * @param place where it belongs, in lists of several families
	 */
	#card(studio: Studio, model: PageModel, preset: Preset, place?: string): TemplateResult {
		const { specimen, dark, ui } = studio.state;
		const chosen = model.name === specimen.model && preset.name === specimen.preset;
		const key = presetKey(model, preset);
		const isFavourite = ui.favourites.includes(key);
		const label = text(isFavourite ? "favourite_remove" : "favourite_add", { title: preset.title });
		return html`<li>
			<button
				class="preset" type="button" aria-current=${chosen} title=${described(preset)} data-preset=${preset.name} tabindex="-1"
				@click=${() => this.#choose(studio, model, preset)}
			>${cardContent(model, preset, dark, place)}</button>
			<button
				class="favourite" type="button" aria-pressed=${isFavourite} aria-label=${label} title=${label}
				@click=${() => studio.toggleFavourite(key)}
			>${icon(isFavourite ? "starred" : "star")}</button>
		</li>`;
	}

	/** Renders the message of a search without result, with a button that shows all presets. */
	#nothingFound(): TemplateResult {
		return html`<p class="none">${text("gallery_none", { query: this.#query.trim() })}
			<button class="button" type="button" @click=${() => this.#setFilter({ query: "", shelf: "all", method: "" })}>${text("gallery_show_all")}</button></p>`;
	}

	/** Closes the dialog and grows a preset. */
	#choose(studio: Studio, model: PageModel, { name }: Preset): void {
		this.#close();
		studio.choosePreset(name, model);
	}

	/** Changes search or filters and scrolls to the top. */
	#setFilter({ query = this.#query, shelf = this.#shelf, method = this.#method }: Partial<BrowseFilter>): void {
		this.#query = query;
		this.#shelf = shelf;
		this.#method = method;
		this.requestUpdate();
		const list = this.querySelector(".browse-list");
		if (list) list.scrollTop = 0;
	}

	/**
	 * Handles a key of the search: arrow down goes to the presets, Enter chooses the first, Escape empties the search.
	 */
	#searchKey(event: KeyboardEvent): void {
		if (event.key === "Escape" && this.#query !== "") {
			event.preventDefault();
			this.#setFilter({ query: "" });
		} else if (event.key === "ArrowDown" || event.key === "Enter") {
			event.preventDefault();
			const [first] = this.#items();
			if (event.key === "ArrowDown") first?.focus();
			else if (this.#query !== "") first?.click();
		}
	}

	/** Moves the focus among the presets by a key. */
	#listKey(event: KeyboardEvent): void {
		if ((event.target as HTMLElement).matches(".preset")) rove(event, this.#items());
	}

	/** Makes one preset the stop of the Tab key. */
	protected override updated(): void {
		const items = this.#items();
		const stop = items.find((item) => item.getAttribute("aria-current") === "true") ?? items[0];
		stopAt(items, items.find((item) => item === document.activeElement) ?? stop);
	}

	/** Returns the presets that can be focused: those in a folded part cannot. */
	#items(): HTMLElement[] {
		return [...this.querySelectorAll<HTMLElement>(".preset")].filter((item) => !item.closest("details:not([open])"));
	}

	/** Closes the dialog. */
	readonly #close = (): void => this.querySelector("dialog")?.close();

	/** Empties the dialog after it has been closed. */
	#closed(): void {
		this.#isOpen = false;
		this.requestUpdate();
	}
}

/** Returns all presets of sections, in their order. */
const placedIn = (sections: readonly PresetSection[]): readonly PlacedPreset[] =>
	sections.flatMap(({ model, kind, presets }) => presets.map((preset) => ({ model, kind, preset })));

/** The search and the filters of the gallery. */
interface BrowseFilter {
	readonly query: string;
	readonly shelf: Shelf;
	readonly method: string;
}

customElements.define("panicle-browse", BrowseDialog);
