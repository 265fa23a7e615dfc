import { html } from "lit";
import { live } from "lit/directives/live.js";
import type { ChoiceEntry } from "../specimen/table";
import { EntryElement } from "./entry_element";

/** Largest number of options shown side by side; more of them are shown as a drop-down list. */
const MOST_SIDE_BY_SIDE = 3;

/** Control of a choice: radio buttons side by side, or a drop-down list. Each choice is an undo step. */
export class ChoiceControl extends EntryElement<ChoiceEntry> {
	protected override draw(): unknown {
		const { key, help, options } = this.entry;
		const changed = this.value === this.published ? "" : "changed";
		return html`<div class="control choice ${changed}" data-key=${key} @keydown=${this.#keyDown}>
			${options.length > MOST_SIDE_BY_SIDE ? this.#list() : this.#buttons()}
			<span class="unseen" id=${this.idOf("help")}>${help}</span>
		</div>`;
	}

	#list(): unknown {
		const { label, options } = this.entry;
		return html`<label for=${this.idOf("choose")} @dblclick=${this.reset}>${label}</label>
			<select
				id=${this.idOf("choose")} .value=${live(String(this.value))} aria-describedby=${this.idOf("help")}
				@change=${(event: Event) => this.#choose(Number((event.target as HTMLSelectElement).value))}
			>
				${options.map((option, value) => html`<option value=${value} ?selected=${value === this.value}>${inWords(option)}</option>`)}
			</select>`;
	}

	#buttons(): unknown {
		const { label, options } = this.entry;
		return html`<span id=${this.idOf("name")} class="label" @dblclick=${this.reset}>${label}</span>
			<div class="segments" role="radiogroup" aria-labelledby=${this.idOf("name")} aria-describedby=${this.idOf("help")}>
				${options.map(
					(option, value) => html`<label>
						<input
							type="radio" name=${this.idOf("options")} .checked=${live(value === this.value)} @change=${() => this.#choose(value)}
						>${inWords(option)}
					</label>`,
				)}
			</div>`;
	}

	#choose(value: number): void {
		this.context.set(this.change(value));
	}

	#keyDown({ key }: KeyboardEvent): void {
		if (key === "Delete" || key === "Backspace") this.reset();
	}
}

/** Formats an option of links for people: "Natural". */
export function inWords(option: string): string {
	return option.charAt(0).toUpperCase() + option.slice(1).replaceAll("_", " ");
}

customElements.define("panicle-choice", ChoiceControl);
