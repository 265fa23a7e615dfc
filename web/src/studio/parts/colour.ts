import { html } from "lit";
import type { ColourKey, ParameterInfo } from "../../models/bunch/parameters.generated";
import type { Studio } from "../studio";
import { StudioElement } from "./studio_element";

/** A colour of the look: the system's picker and the same six digits to type. */
export class ColourControl extends StudioElement {
	static override properties = { ...StudioElement.properties, info: { attribute: false } };
	declare info: ParameterInfo;

	protected override draw(studio: Studio): unknown {
		const { key, label, help } = this.info;
		const value = studio.state.specimen.look[key as ColourKey];
		const original = studio.preset.look[key as ColourKey];
		return html`<div class="control colour ${value === original ? "" : "changed"}" data-key=${key}>
			<label for="slide-${key}" @dblclick=${() => this.#set(original)}>${label}</label>
			<input
				type="color" id="slide-${key}" .value=${`#${value}`} aria-describedby="help-${key}"
				@input=${(event: Event) => studio.edit({ look: { [key]: digits(event) } })}
				@change=${(event: Event) => this.#set(digits(event))}
			>
			<input
				class="typed" type="text" autocomplete="off" spellcheck="false" maxlength="7" .value=${value}
				aria-label="${label}, six hexadecimal digits" @change=${this.#type}
			>
			<span class="unseen" id="help-${key}">${help}</span>
		</div>`;
	}

	#set(colour: string): void {
		this.studio.set({ look: { [this.info.key]: colour } });
	}

	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const colour = field.value.trim().replace("#", "").toLowerCase();
		if (/^[0-9a-f]{6}$/.test(colour)) this.#set(colour);
		else this.studio.notify(`“${field.value}” is not a colour`, ["A colour is six hexadecimal digits, like 43264f."]);
		field.value = this.studio.state.specimen.look[this.info.key as ColourKey];
	}
}

function digits(event: Event): string {
	return (event.target as HTMLInputElement).value.slice(1).toLowerCase();
}

customElements.define("panicle-colour", ColourControl);
