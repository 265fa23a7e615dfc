import { html, nothing } from "lit";
import { LANGUAGES } from "../../locale/locale";
import { text as ui } from "../../ui/messages.generated";
import { notInLink } from "../address";
import { text as app } from "../messages.generated";
import { HINTS, SHORTCUTS } from "../parts/late_parts";
import { openPart } from "../parts/open_part";
import { sheetHeader } from "../parts/sheet_header";
import { StudioPart } from "../parts/studio_part";
import type { Studio } from "../studio";
import type { StudioState } from "../studio_state";
import { VERSION } from "../version";
import { text } from "./messages.generated";
import { picturesOf } from "./pictures";
import { docsLinks, SECTIONS, type SectionKey, sectionTitle } from "./sections";
import "../style/sheets.css";
import "../style/help.css";

/** Extensions of grammars' files. */
const EXTENSIONS = html`<code>.lsys</code>, <code>.gl3</code>, <code>.growth</code>, <code>.stand</code>`;

/** Renders the name of a button or a part of the page, within a sentence. */
const named = (name: string) => html`<i>${name}</i>`;

/** The help: a page with its contents at the side, in a dialog. */
export class Help extends StudioPart {
	/** Returns the values whose change redraws the help. */
	protected override shows({ state: { model, modelUi, ui, dark, specimen } }: Studio): readonly unknown[] {
		return [model, modelUi, ui.language, dark, notInLink(model, specimen).join()];
	}

	/** Renders the contents and the sections. */
	protected override draw({ state }: Studio): unknown {
		return html`<dialog class="help sheet-dialog help-page" closedby="any" aria-labelledby=${this.idOf("title")}>
			${sheetHeader(this.idOf("title"), app("help"))}
			<nav aria-label=${text("contents")}>
				<ul>${SECTIONS.map((key) => html`<li><a href="#${this.idOf(key)}" @click=${(event: Event) => this.#follow(event, key)}>${sectionTitle(key)}</a></li>`)}</ul>
			</nav>
			<div class="help-body">${SECTIONS.map((key) => this.#section(key, state))}</div>
		</dialog>`;
	}

	/** Renders a section: title, pictures, text, and links to the documentation. */
	#section(key: SectionKey, state: StudioState): unknown {
		const title = this.idOf(key);
		const links = docsLinks(key, state.model.name);
		return html`<section aria-labelledby=${title}>
			<h3 id=${title} tabindex="-1">${sectionTitle(key)}</h3>
			${picturesOf(key, state.dark)}
			${this.#body(key, state)}
			${
				links.length === 0
					? nothing
					: html`<p class="help-more"><span id=${`${title}-more`}>${text("more")}</span>
						${links.map((link) => html`<a href=${link.address} target="_blank" aria-describedby=${`${title}-more`}>${link.title}</a> `)}
					</p>`
			}
		</section>`;
	}

	/** Renders the text and the controls of a section. */
	#body(key: SectionKey, state: StudioState): unknown {
		const browse = named(app("browse"));
		const myPlants = named(app("saved"));
		switch (key) {
			case "start":
				return html`<ol>
					<li>${text.pieces("start_choose", { browse })}</li>
					<li>${text("start_change")}</li>
					<li>${text.pieces("start_vary", { variation: named(app("variation_new")) })}</li>
					<li>${text.pieces("start_share", { share: named(app("share")), download: named(app("download")) })}</li>
					<li>${text.pieces("start_undo", { undo: named(app("undo")) })}</li>
				</ol>
				<p><button class="button" type="button" @click=${this.#showTips}>${text("start_tips")}</button></p>`;
			case "shape":
				return html`<p>${text("shape_points")}</p>
					<p>${text("shape_sliders")}</p>
					<p>${text.pieces("shape_targets", { numbers: named(app("panel_numbers")) })}</p>
					<h4>${text("shape_model", { model: state.model.title })}</h4>
					${state.modelUi?.about}
					${state.model.preview ? html`<p>${app("preview_remark")}</p>` : nothing}`;
			case "view":
				return html`<p>${text("view_turn")}</p>
					<p>${text.pieces("view_reset", { reset: named(app("stage_reset")), wind: named(app("stage_wind")) })}</p>
					<p>${text.pieces("view_outdoors", { outdoors: named(app("stage_outdoors")) })}</p>
					<p>${text.pieces("view_scale", { palette: named(app("palette")), scale: named(app("stage_scale")) })}</p>
					<p>${text.pieces("view_present", { present: named(app("stage_present")) })}</p>
					<p>${text.pieces("view_measure", { measure: named(app("stage_measure")) })}</p>
					<p>${text.pieces("view_room", { room: named(app("room")) })}</p>
					<p>${text.pieces("view_names", { names: named(app("stage_names")) })}</p>
					<p>${text("view_enlarge")}</p>`;
			case "growth":
				return html`<p>${text.pieces("growth_age", { play: named(ui("play")) })}</p>
					<p>${text("growth_seed")}</p>
					<p>${text("growth_grammar")}</p>`;
			case "files":
				return html`<p>${text("files_address")}</p>
					<p>${text.pieces("files_open", { open: named(app("open")), extensions: EXTENSIONS })}</p>
					<p>${text.pieces("files_saved", { my_plants: myPlants })}</p>`;
			case "find":
				return html`<p>${text.pieces("find_browse", { browse })}</p>
					<p>${text.pieces("find_palette", { palette: named(app("palette")) })}</p>
					<p>${text.pieces("find_saved", { my_plants: myPlants })}</p>`;
			case "keyboard":
				return html`<p>${text("keyboard_all")}</p>
					<p><button class="button" type="button" @click=${this.#openShortcuts}>${app("shortcuts")}</button></p>`;
			case "language":
				return this.#languages(state);
			case "about":
				return html`<p>${text("version", { version: VERSION })}</p>`;
		}
	}

	/** Renders the choice of the language, and what the reload after it would lose. */
	#languages({ model, specimen, ui }: StudioState): unknown {
		const options = [{ key: "", name: text("language_browser") }, ...LANGUAGES];
		return html`<p>${text("language_page")}</p>
			<p class="languages">
				<label>${text("language")}
					<select aria-describedby=${this.idOf("reload")} @change=${this.#chooseLanguage}>
						${options.map(({ key, name }) => html`<option value=${key} lang=${key || nothing} ?selected=${key === ui.language}>${name}</option>`)}
					</select>
				</label>
				<small id=${this.idOf("reload")}>${text("language_reload")} ${notInLink(model, specimen).join(" ")}</small>
			</p>`;
	}

	/** Stores the chosen language, after which the page reloads in it. */
	#chooseLanguage(event: Event): void {
		this.context.setUi({ language: (event.target as HTMLSelectElement).value });
	}

	/** Shows the hints of the first visit again. */
	#showTips(): void {
		this.querySelector("dialog")?.close();
		void openPart(this.context, HINTS);
	}

	/** Opens the list of keyboard shortcuts in place of the help. */
	#openShortcuts(): void {
		this.querySelector("dialog")?.close();
		void openPart(this.context, SHORTCUTS);
	}

	/** Follows a link of the contents, without changing the address. */
	#follow(event: Event, key: SectionKey): void {
		event.preventDefault();
		this.#show(key);
	}

	/** Scrolls to a section and moves the focus to its heading. */
	#show(key: SectionKey): void {
		const heading = this.querySelector<HTMLElement>(`#${this.idOf(key)}`);
		heading?.scrollIntoView({ block: "start" });
		heading?.focus({ preventScroll: true });
	}

	/**
	 * Opens the help at its beginning, or at a section; the browser traps and restores the focus.
	 */
	async open(section?: SectionKey): Promise<void> {
		await this.updateComplete;
		const dialog = this.querySelector("dialog");
		if (dialog && !dialog.open) dialog.showModal();
		if (section) this.#show(section);
		else for (const place of this.querySelectorAll("dialog, .help-body")) place.scrollTop = 0;
	}
}

customElements.define("panicle-help", Help);
