import { html, nothing, type PropertyValues, svg, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { icon } from "../../controls/icons";
import { rove } from "../../controls/roving";
import { findSaved, ORDERS, type Order } from "../saved/found";
import type { Library } from "../saved/library";
import { LONGEST_NAME, modelOf, presetOf, type Saved, tidyName } from "../saved/saved";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";
import "./saved_picture";

const PEN = svg`<path d="m4 16 .8-3.4L13.4 4l2.6 2.6-8.6 8.6zM11.6 5.8l2.6 2.6"/>`;
const BIN = svg`<path d="M4 6h12M8 6V3.5h4V6M5.5 6l.8 10.5h7.4L14.5 6M8.5 9v4.5M11.5 9v4.5"/>`;

/**
 * The specimens of a library, as cards to be searched and sorted. They are one stop of the Tab key with the buttons of the one that is
 * gone to: arrow keys go from card to card, F2 renames, Delete deletes. Says by events `open-saved` and `said` what the dialog is to do.
 */
export class SavedList extends StudioPart {
	static override properties = { ...StudioPart.properties, library: { attribute: false } };
	declare library: Library;
	#query = "";
	#order: Order = "newest";
	/** Ids of the card that is gone to, and of that whose name is being typed. */
	#at: string | undefined;
	#renaming: string | undefined;
	#unsubscribe: (() => void) | undefined;

	protected override willUpdate(changed: PropertyValues): void {
		super.willUpdate(changed);
		if (!changed.has("library")) return;
		this.#unsubscribe?.();
		this.#unsubscribe = this.library.subscribe(() => this.requestUpdate());
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#unsubscribe?.();
	}

	protected override shows({ state: { catalogue } }: Studio): readonly unknown[] {
		return [catalogue];
	}

	protected override draw(): TemplateResult {
		const found = this.#found();
		return html`<div class="find" role="search" aria-label="Saved">
				<input
					type="search" aria-label="Search what is saved" placeholder="Search" autocomplete="off" spellcheck="false" .value=${this.#query}
					@input=${(event: Event) => this.#look({ query: (event.target as HTMLInputElement).value })}
				>
				<select aria-label="Order" @change=${(event: Event) => this.#look({ order: (event.target as HTMLSelectElement).value as Order })}>
					${Object.entries(ORDERS).map(([key, words]) => html`<option value=${key} ?selected=${key === this.#order}>${words}</option>`)}
				</select>
				<p class="found" role="status">${countInWords(found.length, this.library.all.length)}</p>
			</div>
			<ul class="cards" @keydown=${this.#key} @focusin=${this.#focused}>${repeat(
				found,
				({ id }) => id,
				(saved) => this.#card(saved),
			)}</ul>`;
	}

	#card(saved: Saved): TemplateResult {
		const { id, name } = saved;
		const about = this.idOf(`about-${id}`);
		const kept = this.library.isKept(saved);
		return html`<li data-saved=${id}>
			<button
				class="open" type="button" tabindex="-1" aria-label="Open ${name}" aria-describedby=${about} title="Open ${name}"
				@click=${() => this.dispatchEvent(new CustomEvent("open-saved", { detail: saved }))}
			><panicle-saved-picture .library=${this.library} .saved=${saved} aria-hidden="true"></panicle-saved-picture></button>
			${id === this.#renaming ? this.#nameField(saved) : html`<p class="name" title=${name}>${name}</p>`}
			<p class="about" id=${about}>${this.#modelTitle(saved)}${kept ? nothing : html`<b> not kept</b>`}<br>${dayOf(saved)}</p>
			<div class="of-one">
				<button class="button quiet icon" type="button" tabindex="-1" aria-label="Rename ${name}" title="Rename (F2)" @click=${() => this.#rename(id)}>${icon(PEN)}</button>
				<button class="button quiet icon" type="button" tabindex="-1" aria-label="Delete ${name}" title="Delete" @click=${() => this.#delete(saved)}>${icon(BIN)}</button>
			</div>
		</li>`;
	}

	#nameField({ id, name }: Saved): TemplateResult {
		return html`<form @submit=${(event: Event) => {
			event.preventDefault();
			this.#named(id, (event.target as HTMLFormElement).querySelector("input")?.value ?? "");
		}}><input
			aria-label="New name of ${name}" required autocomplete="off" maxlength=${LONGEST_NAME} .value=${name}
			@keydown=${(event: KeyboardEvent) => {
				event.stopPropagation();
				if (event.key !== "Escape") return;
				event.preventDefault();
				this.#named(id, "");
			}}
			@blur=${({ target }: FocusEvent) => this.#named(id, (target as HTMLInputElement).value)}
		></form>`;
	}

	/** Goes to a card. */
	goTo(id: string | undefined): void {
		this.#at = id;
		this.#stop();
		this.#cards()
			.find(({ dataset }) => dataset.saved === id)
			?.querySelector<HTMLElement>(".open")
			?.focus();
	}

	protected override updated(): void {
		this.#stop();
	}

	/** Of all cards one is a stop of the Tab key, with its buttons. */
	#stop(): void {
		const cards = this.#cards();
		const stop = cards.find(({ dataset }) => dataset.saved === this.#at) ?? cards[0];
		for (const card of cards) {
			for (const button of card.querySelectorAll("button")) button.tabIndex = card === stop ? 0 : -1;
		}
	}

	#found(): readonly Saved[] {
		return findSaved(this.library.all, this.#query, this.#order, (saved) => {
			const preset = presetOf(saved) ?? "";
			return [this.#modelTitle(saved), preset, this.#modelOf(saved)?.presets.named(preset)?.title].join(" ");
		});
	}

	#modelOf(saved: Saved) {
		const { catalogue } = this.desk.state;
		const name = modelOf(saved);
		return catalogue.find((model) => (name === undefined ? model.unnamed : model.name === name));
	}

	#modelTitle = (saved: Saved): string => this.#modelOf(saved)?.title ?? modelOf(saved) ?? "";

	#look({ query = this.#query, order = this.#order }: { query?: string; order?: Order }): void {
		this.#query = query;
		this.#order = order;
		this.requestUpdate();
	}

	async #rename(id: string): Promise<void> {
		this.#renaming = id;
		this.requestUpdate();
		await this.updateComplete;
		this.querySelector<HTMLInputElement>("li input")?.select();
	}

	/** The name is typed; nothing leaves it as it was. */
	async #named(id: string, typed: string): Promise<void> {
		if (this.#renaming !== id) return;
		const held = this.querySelector("li input") === document.activeElement;
		this.#renaming = undefined;
		const name = tidyName(typed);
		const before = this.library.all.find((saved) => saved.id === id)?.name;
		if (name !== "" && name !== before) {
			await this.library.rename(id, name);
			this.#say(`“${before}” is “${name}” now.`);
		}
		this.requestUpdate();
		await this.updateComplete;
		if (held) this.goTo(id);
	}

	async #delete({ id, name }: Saved): Promise<void> {
		const found = this.#found();
		const place = found.findIndex((saved) => saved.id === id);
		await this.library.remove(id);
		if (this.library.all.some((saved) => saved.id === id)) return;
		this.#say(`“${name}” is deleted.`);
		await this.updateComplete;
		this.goTo((found[place + 1] ?? found[place - 1])?.id);
	}

	#say(words: string): void {
		this.dispatchEvent(new CustomEvent("said", { detail: words }));
	}

	#key(event: KeyboardEvent): void {
		const button = event.target as HTMLElement;
		const id = button.closest<HTMLElement>("[data-saved]")?.dataset.saved;
		const saved = this.library.all.find((each) => each.id === id);
		if (!saved) return;
		if (event.key === "F2") void this.#rename(saved.id);
		else if (event.key === "Delete") void this.#delete(saved);
		else if (button.matches(".open")) rove(event, [...this.querySelectorAll<HTMLElement>(".open")]);
	}

	readonly #focused = (event: Event): void => {
		this.#at = (event.target as HTMLElement).closest<HTMLElement>("[data-saved]")?.dataset.saved;
		this.#stop();
	};

	#cards(): HTMLElement[] {
		return [...this.querySelectorAll<HTMLElement>("[data-saved]")];
	}
}

function countInWords(found: number, all: number): string {
	return found === all ? `${all} saved` : `${found} of ${all}`;
}

function dayOf({ at }: Saved): string {
	return at === 0 ? "" : new Date(at).toLocaleDateString("en-GB", { dateStyle: "medium" });
}

customElements.define("panicle-saved-list", SavedList);
