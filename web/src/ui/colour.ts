import { html } from "lit";
import type { ColourEntry } from "../specimen/table";
import type { EditorContext } from "./editor_context";
import { EntryElement } from "./entry_element";

/** Control of a colour: the system's picker, and six digits to type. */
export class ColourControl extends EntryElement<ColourEntry> {
	protected override draw(context: EditorContext): unknown {
		const { key, label, help } = this.entry;
		const { value } = this;
		return html`<div class="control colour ${value === this.published ? "" : "changed"}" data-key=${key}>
			<label for=${this.idOf("pick")} @dblclick=${this.reset}>${label}</label>
			<input
				type="color" id=${this.idOf("pick")} .value=${`#${value}`} aria-describedby=${this.idOf("help")}
				@input=${(event: Event) => context.edit(this.change(digits(event)))}
				@change=${(event: Event) => context.set(this.change(digits(event)))}
			>
			<input
				class="typed" type="text" autocomplete="off" spellcheck="false" maxlength="7" .value=${String(value)}
				aria-label="${label}, six hexadecimal digits" @change=${this.#type}
			>
			<span class="unseen" id=${this.idOf("help")}>${help}</span>
		</div>`;
	}

	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const colour = field.value.trim().replace("#", "").toLowerCase();
		if (/^[0-9a-f]{6}$/.test(colour)) this.context.set(this.change(colour));
		else this.context.notify(`“${field.value}” is not a colour`, ["A colour is six hexadecimal digits, like 43264f."]);
		field.value = String(this.value);
	}
}

function digits(event: Event): string {
	return (event.target as HTMLInputElement).value.slice(1).toLowerCase();
}

customElements.define("panicle-colour", ColourControl);
