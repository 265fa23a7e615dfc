import { html } from "lit";
import { live } from "lit/directives/live.js";
import type { NumberKey, ParameterInfo } from "../../models/bunch/parameters.generated";
import { StudioElement } from "./studio_element";

/** As many options as stand side by side; more of them drop down. */
const MOST_SIDE_BY_SIDE = 3;

/** One parameter that is one of a few: radio buttons side by side, or a list that drops down. Each choice is a step. */
export class ChoiceControl extends StudioElement {
	static override properties = { ...StudioElement.properties, info: { attribute: false } };
	declare info: ParameterInfo;

	protected override draw(): unknown {
		const { key, help } = this.info;
		const options = this.info.options ?? [];
		const changed = this.#value === this.#preset ? "" : "changed";
		return html`<div class="control choice ${changed}" data-key=${key} @keydown=${this.#keyDown}>
			${options.length > MOST_SIDE_BY_SIDE ? this.#list(options) : this.#buttons(options)}
			<span class="unseen" id="help-${key}">${help}</span>
		</div>`;
	}

	#list(options: readonly string[]): unknown {
		const { key, label } = this.info;
		return html`<label for="choose-${key}" @dblclick=${this.#reset}>${label}</label>
			<select
				id="choose-${key}" .value=${live(String(this.#value))} aria-describedby="help-${key}"
				@change=${(event: Event) => this.#choose(Number((event.target as HTMLSelectElement).value))}
			>
				${options.map((option, value) => html`<option value=${value} ?selected=${value === this.#value}>${inWords(option)}</option>`)}
			</select>`;
	}

	#buttons(options: readonly string[]): unknown {
		const { key, label } = this.info;
		return html`<span id="name-${key}" class="label" @dblclick=${this.#reset}>${label}</span>
			<div class="segments" role="radiogroup" aria-labelledby="name-${key}" aria-describedby="help-${key}">
				${options.map(
					(option, value) => html`<label>
						<input type="radio" name=${key} .checked=${live(value === this.#value)} @change=${() => this.#choose(value)}
						>${inWords(option)}
					</label>`,
				)}
			</div>`;
	}

	get #value(): number {
		return this.studio.state.specimen.parameters[this.info.key as NumberKey];
	}

	get #preset(): number {
		return this.studio.preset.parameters[this.info.key as NumberKey];
	}

	#choose(value: number): void {
		this.studio.set({ parameters: { [this.info.key]: value } });
	}

	#reset(): void {
		this.#choose(this.#preset);
	}

	#keyDown({ key }: KeyboardEvent): void {
		if (key === "Delete" || key === "Backspace") this.#reset();
	}
}

/** An option as links write it, as a person reads it: "Natural". */
export function inWords(option: string): string {
	return option.charAt(0).toUpperCase() + option.slice(1).replaceAll("_", " ");
}

customElements.define("panicle-choice", ChoiceControl);
