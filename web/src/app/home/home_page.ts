/** The home page: the families of plants, a search, and ways to files and documentation. It needs no 3-D view and no core. */
import { html, nothing, render } from "lit";
import { icon } from "../../ui/icons";
import { ACCEPT } from "../files/accepted_types";
import { localStorageOr } from "../local_storage";
import { text as appText } from "../messages.generated";
import { describePage } from "../page_description";
import { RecentList } from "../recent/recent_list";
import { ownRecents } from "../recent/recents";
import { applyTheme, isSystemDark, onSystemTheme } from "../theme";
import { saveUi, type UiState } from "../ui_state";
import { type FamilyInfo, families, firstOf, queryOf } from "./families";
import type { FoundPreset } from "./home_search";
import { text } from "./messages.generated";
import "./home.css";

/**
 * Shows the home page.
 * @param stored the interface state of the last visit
 * @param language resolves when the language is loaded
 */
export async function start(stored: UiState, language: Promise<void>): Promise<void> {
	const page = new HomePage(stored);
	const recent = page.readRecent();
	await language;
	describePage({ title: text("title"), about: `${text("sentence")} ${text("details")}` });
	// The list is read within a few milliseconds: with it at once, the families need not move down.
	await Promise.race([recent, new Promise((resolve) => setTimeout(resolve, LONGEST_WAIT))]);
	page.show();
	await recent;
	page.show();
}

/** The longest time that the page waits for the list of recent plants before it shows the families; milliseconds. */
const LONGEST_WAIT = 150;

/** Returns the address of the picture of a family, for the light or the dark theme. */
const pictureOf = (key: string, dark: boolean) =>
	`${import.meta.env.BASE_URL}families/${key}-${dark ? "dark" : "light"}.webp`;

/** Renders the page into an element of its own, again after each change. */
class HomePage {
	readonly #place = document.createElement("div");
	#ui: UiState;
	#query = "";
	/** The plants that match the query; undefined before the first search. */
	#found: readonly FoundPreset[] | undefined;
	#searchFailed = false;
	readonly #recent = new RecentList(ownRecents(), () => this.show());

	constructor(ui: UiState) {
		this.#ui = ui;
		this.#place.className = "home";
		onSystemTheme(() => this.show());
		document.addEventListener("keydown", this.#pressed);
		// The list may have changed while another page was shown in place of this one, or in another tab.
		addEventListener("pageshow", ({ persisted }) => void (persisted && this.#readAgain()));
		document.addEventListener("visibilitychange", () => void (document.hidden || this.#readAgain()));
	}

	/** Reads the recent plants. */
	readRecent(): Promise<void> {
		return this.#recent.read();
	}

	/** Reads the recent plants again, and draws the page if it is in use. */
	async #readAgain(): Promise<void> {
		if (!this.#place.isConnected) return;
		await this.readRecent();
		this.show();
	}

	/** Whether the page is dark. */
	get #dark(): boolean {
		return this.#ui.theme === "system" ? isSystemDark() : this.#ui.theme === "dark";
	}

	/** Draws the page. */
	show(): void {
		if (!this.#place.isConnected) document.body.prepend(this.#place);
		render(this.#page(), this.#place);
	}

	/** Renders the page. */
	#page(): unknown {
		const theme = appText(this.#dark ? "theme_light" : "theme_dark");
		return html`<header class="home-bar">
				<a class="wordmark" href="./" aria-current="page">${emblem()}<span>Panicle</span></a>
				<nav aria-label=${text("links")}>
					<input type="file" hidden accept=${ACCEPT} @change=${this.#picked}>
					<button class="button quiet" type="button" aria-label=${text("open")} title=${text("open_title")} @click=${this.#pick}>${icon("open")}<span class="words">${text("open")}</span></button>
					<a class="button quiet" href="docs/quick-start.html">${text("examples")}</a>
					<a class="button quiet" href="docs/">${text("docs")}</a>
					<button class="button quiet icon" type="button" aria-label=${theme} title=${theme} @click=${this.#switchTheme}>${icon(this.#dark ? "light" : "dark")}</button>
				</nav>
			</header>
			<main class="home-main">
				<h1>${text("sentence")}</h1>
				<p class="home-details">${text("details")}</p>
				${this.#search()}
				${this.#results()}
				${this.#recent.draw({ title: text("continue"), element: html`<h2>${text("continue")}</h2>` })}
				<section aria-labelledby="families-title">
					<h2 id="families-title">${text("families")}</h2>
					<ul class="families">${families().map((family) => this.#family(family))}</ul>
				</section>
			</main>`;
	}

	/** Renders the link to the plant that a family opens with. */
	#family({ key, title, about, model, preset }: FamilyInfo): unknown {
		return html`<li><a class="family" href=${queryOf(model, preset)}>
			<img src=${pictureOf(key, this.#dark)} alt="" width="300" height="240" decoding="async">
			<b>${title}</b> <span>${about}</span>
		</a></li>`;
	}

	/** Renders the field of the search. */
	#search(): unknown {
		return html`<form class="home-search" role="search" @submit=${this.#openFirst}>
			<label><span class="unseen">${text("search")}</span>${icon("search")}<input
				type="search" autocomplete="off" spellcheck="false" placeholder=${text("search_example")}
				aria-keyshortcuts="Control+K Meta+K /" .value=${this.#query} @focus=${() => void this.#loadSearch()} @input=${this.#typed}
			></label>
		</form>`;
	}

	/** Renders the plants found; nothing before a search. */
	#results(): unknown {
		const failed = this.#searchFailed ? html`<p role="alert">${text("search_failed")}</p>` : nothing;
		if (this.#query.trim() === "" || !this.#found) return failed;
		const found = this.#found;
		return html`<section class="home-results" aria-label=${text("results")}>
			<p role="status">${found.length > 0 ? text("found", { count: found.length }) : text("none", { query: this.#query.trim() })}</p>
			<ul>${found.map(
				({ model, preset, title, place, picture }) => html`<li><a class="found-plant" href=${queryOf(model, preset)}>
					${picture ? html`<img src=${picture(this.#dark)} alt="" width="60" height="75" loading="lazy" decoding="async">` : nothing}
					<b>${title}</b> <span>${place}</span>
				</a></li>`,
			)}</ul>
		</section>`;
	}

	/** Moves the focus to the search by the keys of the studio's searches: Ctrl+K or ⌘K, and "/" if single keys are enabled. */
	readonly #pressed = (event: KeyboardEvent): void => {
		const { key, ctrlKey, metaKey, altKey, target } = event;
		if (!this.#place.isConnected || event.defaultPrevented || altKey || document.querySelector("dialog[open]")) return;
		const isTyping = target instanceof HTMLInputElement;
		const isSearch = ctrlKey || metaKey ? key.toLowerCase() === "k" : key === "/" && this.#ui.letters && !isTyping;
		if (!isSearch) return;
		event.preventDefault();
		const field = this.#place.querySelector<HTMLInputElement>("input[type=search]");
		field?.focus();
		field?.select();
	};

	/** Searches again after each letter. */
	readonly #typed = (event: Event): void => {
		this.#query = (event.target as HTMLInputElement).value;
		void this.#find();
	};

	/** Loads the presets of all models, ahead of the first letter. */
	async #loadSearch(): Promise<typeof import("./home_search") | undefined> {
		try {
			const search = await import("./home_search");
			await search.loadPresets();
			this.#searchFailed = false;
			return search;
		} catch {
			this.#searchFailed = true;
			this.show();
			return undefined;
		}
	}

	/** Searches the typed words and draws the result. */
	async #find(): Promise<void> {
		const query = this.#query;
		const search = await this.#loadSearch();
		// A newer query may have been typed meanwhile.
		if (!search || query !== this.#query) return;
		this.#found = search.findPlants(query);
		this.show();
	}

	/** Opens the first plant found, as Enter does in a search. */
	readonly #openFirst = (event: Event): void => {
		event.preventDefault();
		void this.#find().then(() => this.#place.querySelector<HTMLElement>(".found-plant")?.click());
	};

	/** Switches between light and dark. */
	readonly #switchTheme = (): void => {
		const before = this.#ui;
		this.#ui = { ...before, theme: this.#dark ? "light" : "dark" };
		applyTheme(this.#ui.theme);
		saveUi(localStorageOr(), this.#ui, before);
		this.show();
	};

	/** Opens the browser's choice of a file. */
	readonly #pick = (): void => {
		this.#place.querySelector<HTMLElement>("input[type=file]")?.click();
	};

	/** Starts the studio with the file in place of this page. */
	readonly #picked = async (event: Event): Promise<void> => {
		const file = (event.target as HTMLInputElement).files?.[0];
		if (!file) return;
		const { start: startStudio } = await import("../start_studio");
		const { model, preset } = firstOf("grapes");
		history.pushState(null, "", queryOf(model, preset));
		this.#place.remove();
		await startStudio(this.#ui, Promise.resolve(), file);
	};
}

/** Renders the emblem of the app, a small bunch. */
function emblem(): unknown {
	return html`<svg viewBox="0 0 24 28" aria-hidden="true" fill="currentColor">
		<path d="M12 7V1.5" fill="none" stroke="currentColor" stroke-width="1.6" stroke-linecap="round" />
		<circle cx="6" cy="10" r="3.6" /><circle cx="13" cy="9.6" r="3.6" /><circle cx="19.4" cy="11.4" r="3.1" />
		<circle cx="9.2" cy="16" r="3.4" /><circle cx="15.8" cy="16.6" r="3.3" /><circle cx="12.2" cy="22.4" r="3.2" />
	</svg>`;
}
