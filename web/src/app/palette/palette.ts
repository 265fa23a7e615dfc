import { html, nothing, svg } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { LANGUAGES } from "../../locale/locale";
import { icon } from "../../ui/icons";
import { text as appText } from "../messages.generated";
import { StudioPart } from "../parts/studio_part";
import type { TextIndex } from "../search/text_index";
import type { Studio } from "../studio";
import { downloadEntries, fileDialogEntries } from "./downloads";
import { actionEntries, type PaletteEntry, settingEntries, toolEntries } from "./entries";
import { helpEntries, sectionEntries } from "./help_entries";
import { text } from "./messages.generated";
import { recentKeys, rememberKey } from "./recent";
import { recentPlantEntries } from "./recent_plants";
import { entriesToStart, type FoundGroup, findEntries, indexOf } from "./search";
import "../style/palette.css";

const GLOBE = svg`<circle cx="10" cy="10" r="7"/><path d="M3 10h14M10 3c-2.5 2-2.5 12 0 14M10 3c2.5 2 2.5 12 0 14"/>`;
const HOUSE = svg`<path d="M3 10.5 10 4l7 6.5M5 9v7.5h10V9"/>`;

/** Entries that Page Up and Page Down move by. */
const PAGE = 8;

/**
 * The command palette: one field that searches plants, settings, actions and help. It is a combobox: the focus stays in
 * the field, and the arrow keys choose an entry of the list.
 */
export class CommandPalette extends StudioPart {
	#query = "";
	/** All entries but plants, as the palette was opened; empty while it is closed. */
	#entries: readonly PaletteEntry[] = [];
	#index: TextIndex<PaletteEntry> | undefined;
	/** The plants that were open lately, which an empty field lists first. */
	#recentPlants: readonly PaletteEntry[] = [];
	#found: readonly FoundGroup[] = [];
	/** Position of the active entry among the found ones. */
	#at = 0;

	/** Returns the values whose change redraws the palette. */
	protected override shows({ state: { catalogue, dark } }: Studio): readonly unknown[] {
		return [catalogue, dark];
	}

	/** Renders the field, the entries found and their number. */
	protected override draw(studio: Studio): unknown {
		this.#found = this.#index ? this.#find(studio, this.#index) : [];
		const entries = this.#list();
		this.#at = Math.min(this.#at, Math.max(0, entries.length - 1));
		return html`<dialog
			class="palette" aria-label=${text("title")} closedby="any" @keydown=${this.#key} @close=${this.#closed} @click=${this.#clickOutside}
		>
			<div class="palette-field">
				${icon("search")}<input
					type="text" inputmode="search" enterkeyhint="go" autocomplete="off" spellcheck="false" autocapitalize="none"
					role="combobox" aria-expanded=${entries.length > 0} aria-controls=${this.idOf("list")} aria-autocomplete="list"
					aria-activedescendant=${entries.length > 0 ? this.#idAt(this.#at) : nothing}
					aria-label=${text("placeholder")} placeholder=${text("placeholder")} .value=${this.#query} @input=${this.#typed}
				><button class="button quiet icon" type="button" aria-label=${appText("close")} title=${appText("close")} @click=${() => this.#close()}>${icon("close")}</button>
			</div>
			<div class="palette-list" role="listbox" id=${this.idOf("list")} aria-label=${text("results")} ?hidden=${entries.length === 0}>
				${this.#found.map((group) => this.#group(group))}
			</div>
			${entries.length === 0 && this.#query.trim() !== "" ? html`<p class="palette-none">${text("none", { query: this.#query.trim() })}</p>` : nothing}
			<p class="unseen" role="status">${this.#query.trim() === "" ? nothing : text("found", { count: entries.length })}</p>
			<p class="palette-keys" aria-hidden="true">
				<span><kbd>↑</kbd> <kbd>↓</kbd> ${text("hint_choose")}</span>
				<span><kbd>Enter</kbd> ${text("hint_run")}</span>
				<span><kbd>Esc</kbd> ${text("hint_close")}</span>
			</p>
		</dialog>`;
	}

	/** Returns the entries that match the query; for an empty query recent and suggested ones. */
	#find(studio: Studio, index: TextIndex<PaletteEntry>): readonly FoundGroup[] {
		if (this.#query.trim() !== "") return findEntries(studio, index, this.#query);
		return entriesToStart(studio, this.#entries, recentKeys(), this.#recentPlants);
	}

	/** Renders a group of entries. */
	#group({ group, entries }: FoundGroup): unknown {
		const title = this.idOf(`group-${group}`);
		return html`<div role="group" aria-labelledby=${title}>
			<div class="palette-group" role="presentation" id=${title}>${text(`group_${group}`)}</div>
			${repeat(
				entries,
				({ key }) => key,
				(entry) => this.#entry(entry),
			)}
		</div>`;
	}

	/** Renders an entry. */
	#entry(entry: PaletteEntry): unknown {
		const at = this.#list().indexOf(entry);
		const { title, about, keys, picture } = entry;
		return html`<div
			class="palette-entry" role="option" id=${this.#idAt(at)} aria-selected=${at === this.#at} data-entry=${entry.key}
			@pointermove=${() => this.#activate(at)} @click=${() => this.#run(entry)}
		>
			<span class="palette-mark">${
				picture
					? html`<img src=${picture} alt="" width="36" height="45" decoding="async">`
					: entry.icon
						? icon(entry.icon)
						: nothing
			}</span>
			<span class="palette-words"><b>${title}</b> ${about === "" ? nothing : html`<small>${about}</small>`}</span>
			${keys ? html`<kbd>${keys}</kbd>` : nothing}
		</div>`;
	}

	/** Returns the entries found, in the order of the list. */
	#list(): readonly PaletteEntry[] {
		return this.#found.flatMap(({ entries }) => entries);
	}

	/** Returns the id of the element of an entry by its position in the list. */
	readonly #idAt = (at: number): string => this.idOf(`entry-${at}`);

	/** Opens the palette with an empty field; the browser traps and restores the focus. */
	async open(): Promise<void> {
		this.#query = "";
		this.#at = 0;
		this.#setEntries([]);
		await this.updateComplete;
		const dialog = this.querySelector("dialog");
		if (dialog && !dialog.open) dialog.showModal();
		this.querySelector<HTMLElement>("input")?.focus();
		void this.#readRecentPlants();
		const loaded = await Promise.allSettled([
			downloadEntries(this.context),
			sectionEntries(this.context),
			helpEntries(this.context),
		]);
		const late = loaded.flatMap((entries) => (entries.status === "fulfilled" ? entries.value : []));
		if (this.#index) this.#setEntries(late);
	}

	/** Reads the plants that were open lately, and lists them unless the user has chosen an entry already. */
	async #readRecentPlants(): Promise<void> {
		const plants = await recentPlantEntries(this.context);
		if (!this.#index || this.#at > 0) return;
		this.#recentPlants = plants;
		this.requestUpdate();
	}

	/** Collects the entries that the studio offers now. @param late those that had to be loaded */
	#setEntries(late: readonly PaletteEntry[]): void {
		const { context } = this;
		this.#entries = [
			...actionEntries(context),
			...toolEntries(context),
			...fileDialogEntries(context),
			...languageEntries(context),
			homeEntry(),
			...settingEntries(context),
			...late,
		];
		this.#index = indexOf(this.#entries);
		this.requestUpdate();
	}

	/** Drops all entries after the dialog has been closed. */
	readonly #closed = (): void => {
		this.#index = undefined;
		this.#entries = [];
		this.#recentPlants = [];
		this.requestUpdate();
	};

	/** Searches again after each letter. */
	readonly #typed = (event: Event): void => {
		this.#query = (event.target as HTMLInputElement).value;
		this.#at = 0;
		this.requestUpdate();
	};

	/**
	 * Closes the palette by a click on the dialog itself: that is one outside of its content, in browsers without
	 * `closedby`.
	 */
	readonly #clickOutside = (event: Event): void => {
		if (event.target === event.currentTarget) this.#close();
	};

	/** Closes the dialog. */
	#close(): void {
		this.querySelector("dialog")?.close();
	}

	/** Makes the entry at a position the active one. */
	#activate(at: number): void {
		if (at === this.#at) return;
		this.#at = at;
		this.requestUpdate();
	}

	/** Handles a key: arrows and Page Up, Page Down choose an entry, Enter runs it, Ctrl+K closes the palette. */
	#key(event: KeyboardEvent): void {
		const count = this.#list().length;
		const next = {
			ArrowDown: (this.#at + 1) % count,
			ArrowUp: (this.#at - 1 + count) % count,
			PageDown: Math.min(count - 1, this.#at + PAGE),
			PageUp: Math.max(0, this.#at - PAGE),
		}[event.key];
		const isShortcut = event.key.toLowerCase() === "k" && (event.ctrlKey || event.metaKey);
		if (isShortcut) this.#close();
		else if (event.key === "Enter" && !event.isComposing) this.#runActive();
		else if (next !== undefined && count > 0) this.#choose(next);
		else return;
		event.preventDefault();
	}

	/** Makes an entry the active one, and scrolls to it. */
	#choose(at: number): void {
		this.#activate(at);
		void this.updateComplete.then(() => {
			const heading = at === 0 ? this.querySelector(".palette-group") : undefined;
			(heading ?? this.querySelector("[aria-selected=true]"))?.scrollIntoView({ block: "nearest" });
		});
	}

	/** Runs the active entry. */
	#runActive(): void {
		const entry = this.#list()[this.#at];
		if (entry) this.#run(entry);
	}

	/**
	 * Closes the palette and runs an entry, within the user's key press or click, since browsers open files and tabs only
	 * then. Announces the result.
	 */
	#run(entry: PaletteEntry): void {
		this.#close();
		rememberKey(entry.key);
		void entry.run();
		if (entry.done) this.context.notify(entry.done(), [], { topic: "palette", brief: true });
	}
}

/** Returns the choices of a language; the page reloads in the chosen one. */
function languageEntries(studio: Studio): readonly PaletteEntry[] {
	return LANGUAGES.filter(({ key }) => key !== document.documentElement.lang).map(({ key, name }) => ({
		key: `language:${key}`,
		group: "actions",
		title: text("language", { name }),
		about: "",
		icon: GLOBE,
		texts: { title: text("language", { name }), names: ["language", "langue", name] },
		run: () => studio.setUi({ language: key }),
	}));
}

/** Returns the entry that goes to the home page; Back returns to the plant. */
const homeEntry = (): PaletteEntry => ({
	key: "action:home",
	group: "actions",
	title: text("home"),
	about: "",
	icon: HOUSE,
	texts: { title: text("home"), names: ["home", "families"] },
	run: () => location.assign("./"),
});

customElements.define("panicle-palette", CommandPalette);
