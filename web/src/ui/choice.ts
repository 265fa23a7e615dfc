import { html } from "lit";
import { live } from "lit/directives/live.js";
import type { ChoiceEntry } from "../specimen/table";
import { optionInWords } from "../specimen/translated_tables";
import { EntryElement } from "./entry_element";
import { explanation } from "./slider_row";

/** Largest number of options shown side by side; more of them are shown as a drop-down list. */
const MAX_SIDE_BY_SIDE = 3;

/** Control of a choice: radio buttons side by side, or a drop-down list. Each choice is an undo step. */
export class ChoiceControl extends EntryElement<ChoiceEntry> {
	/** Renders the options as radio buttons side by side or, if there are many, as a drop-down list. */
	protected override draw(): unknown {
		const { key, help, label, options } = this.entry;
		const published = this.#label(options[Number(this.published)], Number(this.published));
		const changed = this.value === this.published ? "" : "changed";
		return html`<div class="control choice ${changed}" data-key=${key} @keydown=${this.#keyDown}>
			${options.length > MAX_SIDE_BY_SIDE ? this.#list() : this.#buttons()}
			<panicle-info .name=${label} .text=${explanation(help, published)}></panicle-info>
			<span class="unseen" id=${this.idOf("help")}>${help}</span>
		</div>`;
	}

	/** Renders the options as a drop-down list. */
	#list(): unknown {
		const { label, options } = this.entry;
		return html`<label for=${this.idOf("choose")} @dblclick=${this.reset}>${label}</label>
			<select
				id=${this.idOf("choose")} .value=${live(String(this.value))} aria-describedby=${this.idOf("help")}
				@change=${(event: Event) => this.#choose(Number((event.target as HTMLSelectElement).value))}
			>
				${options.map((option, value) => html`<option value=${value} ?selected=${value === this.value}>${this.#label(option, value)}</option>`)}
			</select>`;
	}

	/** Renders the options as a row of radio buttons. */
	#buttons(): unknown {
		const { label, options } = this.entry;
		return html`<span id=${this.idOf("name")} class="label" @dblclick=${this.reset}>${label}</span>
			<div class="segments" role="radiogroup" aria-labelledby=${this.idOf("name")} aria-describedby=${this.idOf("help")}>
				${options.map(
					(option, value) => html`<label>
						<input
							type="radio" name=${this.idOf("options")} .checked=${live(value === this.value)} @change=${() => this.#choose(value)}
						>${this.#label(option, value)}
					</label>`,
				)}
			</div>`;
	}

	/** Returns the option's name for people. */
	#label(option: string, value: number): string {
		return this.entry.labels?.[value] ?? optionInWords(option);
	}

	/** Chooses the option of an index, as an undo step. */
	#choose(value: number): void {
		this.context.set(this.change(value));
	}

	/** Restores the preset's value by Delete or Backspace. */
	#keyDown({ key }: KeyboardEvent): void {
		if (key === "Delete" || key === "Backspace") this.reset();
	}
}

customElements.define("panicle-choice", ChoiceControl);
