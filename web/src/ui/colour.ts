import { html } from "lit";
import type { ColourEntry } from "../specimen/table";
import type { EditorContext } from "./editor_context";
import { EntryElement } from "./entry_element";
import { text } from "./messages.generated";
import { explanation } from "./slider_row";

/** Control of a colour: the system's picker, and six digits to type. */
export class ColourControl extends EntryElement<ColourEntry> {
	/** Renders the browser's colour picker and a text field for the hexadecimal value. */
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
				aria-label=${text("colour_field", { label })} @change=${this.#type}
			>
			<panicle-info .name=${label} .text=${explanation(help, `#${this.published}`)}></panicle-info>
			<span class="unseen" id=${this.idOf("help")}>${help}</span>
		</div>`;
	}

	/** Sets a typed colour; a notice reports text that is not six hexadecimal digits. */
	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const colour = field.value.trim().replace("#", "").toLowerCase();
		if (/^[0-9a-f]{6}$/.test(colour)) this.context.set(this.change(colour));
		else this.context.notify(text("colour_invalid", { value: field.value }), [text("colour_format")]);
		field.value = String(this.value);
	}
}

/** Returns the six digits of a colour input's value. */
function digits(event: Event): string {
	return (event.target as HTMLInputElement).value.slice(1).toLowerCase();
}

customElements.define("panicle-colour", ColourControl);
