import { html, nothing, type PropertyValues, svg, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { repeat } from "lit/directives/repeat.js";
import { formatDate } from "../../locale/format";
import { icon } from "../../ui/icons";
import { VirtualRows } from "../../ui/virtual_rows";
import { text } from "../messages.generated";
import { findSaved, ORDERS, type SavedOrder } from "../saved/found";
import type { Library } from "../saved/library";
import { countAndName, LONGEST_NAME, modelOf, presetOf, type Saved, tidyName } from "../saved/saved";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";
import "./saved_picture";

const PEN = svg`<path d="m4 16 .8-3.4L13.4 4l2.6 2.6-8.6 8.6zM11.6 5.8l2.6 2.6"/>`;
const BIN = svg`<path d="M4 6h12M8 6V3.5h4V6M5.5 6l.8 10.5h7.4L14.5 6M8.5 9v4.5M11.5 9v4.5"/>`;

/** Least width of a card, the space between cards, and the expected height of one, in CSS pixels. */
const CARD = { width: 124, gap: 12, height: 250 };
/** Rows that Page Up and Page Down move by. */
const PAGE = 3;

/**
 * The specimens of a library as cards, with search, order and selection; only visible rows are in the page. The cards
 * are one stop of the Tab key with the buttons of the active card: arrow keys move between cards, F2 renames, Delete
 * deletes. Dispatches `open-saved` with a specimen and `message` with a text.
 */
export class SavedList extends StudioPart {
	static override properties = { ...StudioPart.properties, library: { attribute: false } };
	declare library: Library;
	#query = "";
	#order: SavedOrder = "newest";
	/** The search result in order; undefined after a change, until it is needed. */
	#result: readonly Saved[] | undefined;
	/** Ids of the active card and of the card that is being renamed. */
	#at: string | undefined;
	#renaming: string | undefined;
	/** Ids of the selected cards, and of the card whose selection changed last. */
	#selected: ReadonlySet<string> = new Set();
	#anchor: string | undefined;
	#columns = 1;
	readonly #rows = new VirtualRows(this, {
		scroller: () => this.closest("dialog"),
		list: () => this.querySelector<HTMLElement>(".cards"),
		rowHeight: CARD.height,
		gap: CARD.gap,
	});
	readonly #resized = new ResizeObserver(([{ contentRect }]) => this.#fit(contentRect.width));
	#unsubscribe: (() => void) | undefined;

	/** Follows another library before drawing its specimens. */
	protected override willUpdate(changed: PropertyValues): void {
		super.willUpdate(changed);
		if (!changed.has("library")) return;
		this.#result = undefined;
		this.#unsubscribe?.();
		this.#unsubscribe = this.library.subscribe(() => this.#search());
	}

	/** Stops following library and size. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#unsubscribe?.();
		this.#resized.disconnect();
	}

	/** Returns the values whose change redraws the list. */
	protected override shows({ state: { catalogue } }: Studio): readonly unknown[] {
		return [catalogue];
	}

	/** Renders search, order, selection and the visible rows of cards. */
	protected override draw(): TemplateResult {
		const found = this.#found();
		const active = Math.max(0, this.#indexOf(this.#at));
		const rows = this.#rows.rows(Math.ceil(found.length / this.#columns), [Math.floor(active / this.#columns)]);
		const { height } = this.#rows;
		return html`<div class="find" role="search" aria-label=${text("saved")}>
				<input
					type="search" aria-label=${text("saved_search")} placeholder=${text("saved_search_placeholder")} autocomplete="off" spellcheck="false" .value=${this.#query}
					@input=${(event: Event) => this.#setFilter({ query: (event.target as HTMLInputElement).value })}
				>
				<select aria-label=${text("saved_order")} @change=${(event: Event) => this.#setFilter({ order: (event.target as HTMLSelectElement).value as SavedOrder })}>
					${ORDERS.map((key) => html`<option value=${key} ?selected=${key === this.#order}>${text(`saved_order_${key}`)}</option>`)}
				</select>
				<p class="found" role="status">${countInWords(found.length, this.library.all.length)}</p>
			</div>
			${this.#selection(found)}
			<div class="cards" role="list" aria-label=${text("saved_list")} .style=${`height: ${height}px; --columns: ${this.#columns}`} @keydown=${this.#key} @focusin=${this.#focused}>${repeat(
				rows,
				({ index }) => index,
				(row) =>
					html`<div class="row" role="presentation" data-index=${row.index} .style=${this.#rows.rowStyle(row)}>${repeat(
						this.#inRow(found, row.index),
						({ id }) => id,
						(saved, column) => this.#card(saved, row.index * this.#columns + column, found.length),
					)}</div>`,
			)}</div>`;
	}

	/** Renders the checkbox that selects all results, and the actions on the selected cards. */
	#selection(found: readonly Saved[]): TemplateResult {
		const count = this.#selected.size;
		const all = count > 0 && count === found.length;
		return html`<div class="selection" role="group" aria-label=${text("saved_selection")}>
			<label class="toggle"><input
				type="checkbox" .checked=${live(all)} .indeterminate=${live(count > 0 && !all)} ?disabled=${found.length === 0}
				@change=${() => this.#select(all ? [] : found.map(({ id }) => id))}
			>${text("saved_select_all")}</label>
			<p role="status">${count > 0 ? text("saved_selected", { count }) : nothing}</p>
			${count > 0 ? html`<button class="button" type="button" title=${text("saved_delete_selected_title")} @click=${() => this.#delete([...this.#selected])}>${icon(BIN)} ${text("saved_delete_selected", { count })}</button>` : nothing}
		</div>`;
	}

	/**
	 * Renders a saved plant.
	 * @param index position among the found ones
	 * @param count number of found ones
	 */
	#card(saved: Saved, index: number, count: number): TemplateResult {
		const { id, name } = saved;
		const about = this.idOf(`about-${id}`);
		const isStored = this.library.isStored(saved);
		return html`<div role="listitem" data-saved=${id} aria-posinset=${index + 1} aria-setsize=${count}>
			<button
				class="open" type="button" tabindex="-1" aria-label=${text("saved_open", { name })} aria-describedby=${about} title=${text("saved_open", { name })}
				@click=${() => this.dispatchEvent(new CustomEvent("open-saved", { detail: saved }))}
			><panicle-saved-picture .library=${this.library} .saved=${saved} aria-hidden="true"></panicle-saved-picture></button>
			<label class="pick" title=${text("saved_select_title")}><input
				type="checkbox" tabindex="-1" aria-label=${text("saved_select", { name })} .checked=${live(this.#selected.has(id))}
				@click=${(event: MouseEvent) => this.#pick(id, event)}
			></label>
			${id === this.#renaming ? this.#nameField(saved) : html`<p class="name" title=${name}>${name}</p>`}
			<p class="about" id=${about}>${this.#modelTitle(saved)}${isStored ? nothing : html` <b>${text("saved_not_stored")}</b>`}<br>${dayOf(saved)}</p>
			<div class="of-one">
				<button class="button quiet icon" type="button" tabindex="-1" aria-label=${text("saved_rename", { name })} title=${text("saved_rename_title")} @click=${() => this.#rename(id)}>${icon(PEN)}</button>
				<button class="button quiet icon" type="button" tabindex="-1" aria-label=${text("saved_delete", { name })} title=${text("saved_delete_title")} @click=${() => this.#delete([id])}>${icon(BIN)}</button>
			</div>
		</div>`;
	}

	/** Renders the field that renames a plant: Enter or leaving it stores the name, Escape leaves the old one. */
	#nameField({ id, name }: Saved): TemplateResult {
		return html`<form @submit=${(event: Event) => {
			event.preventDefault();
			this.#named(id, (event.target as HTMLFormElement).querySelector("input")?.value ?? "");
		}}><input
			aria-label=${text("saved_rename_field", { name })} required autocomplete="off" maxlength=${LONGEST_NAME} .value=${name}
			@keydown=${(event: KeyboardEvent) => {
				event.stopPropagation();
				if (event.key !== "Escape") return;
				event.preventDefault();
				this.#named(id, "");
			}}
			@blur=${({ target }: FocusEvent) => this.#named(id, (target as HTMLInputElement).value)}
		></form>`;
	}

	/** Moves the focus to a card, which scrolls into view. */
	async goTo(id: string | undefined): Promise<void> {
		this.#at = id;
		this.requestUpdate();
		await this.updateComplete;
		this.#cards()
			.find(({ dataset }) => dataset.saved === id)
			?.querySelector<HTMLElement>(".open")
			?.focus();
	}

	/** Moves the focus to the first of some cards, in the order of the list. */
	async goToFirst(ids: readonly string[]): Promise<void> {
		await this.goTo(this.#found().find(({ id }) => ids.includes(id))?.id);
	}

	/** Starts to follow the width of the list. */
	protected override firstUpdated(): void {
		const cards = this.querySelector(".cards");
		if (cards) this.#resized.observe(cards);
	}

	/** Measures the rows and updates the stop of the Tab key. */
	protected override updated(): void {
		this.#rows.measure();
		this.#stop();
	}

	/** Sets the number of columns that fit. */
	#fit(width: number): void {
		const columns = Math.max(1, Math.floor((width + CARD.gap) / (CARD.width + CARD.gap)));
		if (columns === this.#columns) return;
		this.#columns = columns;
		this.#rows.forget();
		this.requestUpdate();
	}

	/** Makes one card, with its buttons, the stop of the Tab key. */
	#stop(): void {
		const cards = this.#cards();
		const stop = cards.find(({ dataset }) => dataset.saved === this.#at) ?? cards[0];
		for (const card of cards) {
			for (const item of card.querySelectorAll<HTMLElement>("button, [type=checkbox]")) {
				item.tabIndex = card === stop ? 0 : -1;
			}
		}
	}

	/** Returns the result of the search, in order; computed once after each change. */
	#found(): readonly Saved[] {
		this.#result ??= findSaved(this.library.all, this.#query, this.#order, (saved) => {
			const preset = presetOf(saved) ?? "";
			return [this.#modelTitle(saved), preset, this.#modelOf(saved)?.presets.named(preset)?.title].join(" ");
		});
		return this.#result;
	}

	/** Returns the specimens of a row. */
	#inRow(found: readonly Saved[], row: number): readonly Saved[] {
		return found.slice(row * this.#columns, (row + 1) * this.#columns);
	}

	/** Returns the position of a specimen in the result; −1 where it is not found. */
	#indexOf(id: string | undefined): number {
		return id === undefined ? -1 : this.#found().findIndex((saved) => saved.id === id);
	}

	/** Searches again after a change of the library or the query; cards that are not found are unselected. */
	#search(): void {
		this.#result = undefined;
		if (this.#selected.size > 0) {
			this.#selected = new Set(this.#found().flatMap(({ id }) => (this.#selected.has(id) ? id : [])));
		}
		this.requestUpdate();
	}

	/** Selects cards in place of those that were selected. */
	#select(ids: Iterable<string>): void {
		this.#selected = new Set(ids);
		this.requestUpdate();
	}

	/** Selects or unselects a card; with Shift all cards from the last changed one to it. */
	#pick(id: string, { shiftKey }: MouseEvent): void {
		const [from, to] = [this.#indexOf(this.#anchor), this.#indexOf(id)];
		const first = shiftKey && from >= 0 ? from : to;
		const range = this.#found().slice(Math.min(first, to), Math.max(first, to) + 1);
		const next = new Set(this.#selected);
		const on = !next.has(id);
		for (const each of range) {
			if (on) next.add(each.id);
			else next.delete(each.id);
		}
		this.#anchor = id;
		this.#select(next);
	}

	/** Returns the model of a specimen; undefined before its presets are loaded. */
	#modelOf(saved: Saved) {
		const { catalogue } = this.context.state;
		const name = modelOf(saved);
		return catalogue.find((model) => (name === undefined ? model.unnamed : model.name === name));
	}

	/** Returns the title of a specimen's model, or the model's name before it is loaded. */
	#modelTitle = (saved: Saved): string => this.#modelOf(saved)?.title ?? modelOf(saved) ?? "";

	/** Changes the search or the order. */
	#setFilter({ query = this.#query, order = this.#order }: { query?: string; order?: SavedOrder }): void {
		this.#query = query;
		this.#order = order;
		this.#search();
	}

	/** Shows the field that renames a specimen, with its name selected. */
	async #rename(id: string): Promise<void> {
		this.#renaming = id;
		this.requestUpdate();
		await this.updateComplete;
		this.querySelector<HTMLInputElement>("[data-saved] form input")?.select();
	}

	/** Renames a specimen; an empty name leaves the old one. */
	async #named(id: string, typed: string): Promise<void> {
		if (this.#renaming !== id) return;
		const held = this.querySelector("[data-saved] form input") === document.activeElement;
		this.#renaming = undefined;
		const name = tidyName(typed);
		const before = this.library.all.find((saved) => saved.id === id)?.name;
		if (name !== "" && name !== before) {
			await this.library.rename(id, name);
			this.#announce(text("saved_renamed", { before: before ?? "", name }));
		}
		this.requestUpdate();
		await this.updateComplete;
		if (held) await this.goTo(id);
	}

	/** Deletes specimens; the focus moves to the card after the active one, or else before it. */
	async #delete(ids: readonly string[]): Promise<void> {
		const found = this.#found();
		const gone = new Set(ids);
		const place = Math.max(0, this.#indexOf(ids.length === 1 ? ids[0] : this.#at));
		const stays = ({ id }: Saved) => !gone.has(id);
		const next = found.slice(place).find(stays) ?? found.slice(0, place).findLast(stays);
		const deleted = await this.library.remove(ids);
		if (deleted.length === 0) return;
		this.#announce(text("saved_deleted", countAndName(deleted)));
		await this.updateComplete;
		await this.goTo(next?.id);
	}

	/** Sends a message for screen readers to the dialog. */
	#announce(text: string): void {
		this.dispatchEvent(new CustomEvent("message", { detail: text }));
	}

	/**
	 * Handles a key on a card: F2 renames, Delete deletes the card or the selection it is in, Ctrl+A selects all found
	 * ones, others move the focus.
	 */
	#key(event: KeyboardEvent): void {
		const button = event.target as HTMLElement;
		const id = button.closest<HTMLElement>("[data-saved]")?.dataset.saved;
		const saved = this.library.all.find((each) => each.id === id);
		if (!saved) return;
		const isTyping = button.matches("form input");
		if (event.key === "F2") void this.#rename(saved.id);
		else if (isTyping) return;
		else if (event.key === "Delete") void this.#delete(this.#selected.has(saved.id) ? [...this.#selected] : [saved.id]);
		else if (event.key === "a" && (event.ctrlKey || event.metaKey)) this.#select(this.#found().map(({ id }) => id));
		else {
			if (button.matches(".open")) this.#move(event, this.#indexOf(saved.id));
			return;
		}
		event.preventDefault();
	}

	/** Moves the focus from a card by an arrow key or a page key. */
	#move(event: KeyboardEvent, from: number): void {
		const found = this.#found();
		const columns = this.#columns;
		const to: Readonly<Record<string, number>> = {
			ArrowLeft: from - 1,
			ArrowRight: from + 1,
			ArrowUp: from - columns,
			ArrowDown: from + columns,
			PageUp: Math.max(from % columns, from - PAGE * columns),
			PageDown: Math.min(from + PAGE * columns, found.length - 1),
			Home: 0,
			End: found.length - 1,
		};
		if (to[event.key] === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
		event.preventDefault();
		const next = found[to[event.key]];
		if (next) void this.goTo(next.id);
	}

	/** Makes the card that has received the focus the active one. */
	readonly #focused = (event: Event): void => {
		this.#at = (event.target as HTMLElement).closest<HTMLElement>("[data-saved]")?.dataset.saved;
		this.#stop();
	};

	/** Returns the visible cards. */
	#cards(): HTMLElement[] {
		return [...this.querySelectorAll<HTMLElement>("[data-saved]")];
	}
}

/** Describes the number of specimens found, of all. */
function countInWords(found: number, all: number): string {
	return found === all ? text("saved_count", { count: all }) : text("saved_found", { found, count: all });
}

/** Returns the day on which a specimen was saved; empty where it is unknown. */
function dayOf({ at }: Saved): string {
	return at === 0 ? "" : formatDate(new Date(at));
}

customElements.define("panicle-saved-list", SavedList);
