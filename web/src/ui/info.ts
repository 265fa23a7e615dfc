import { html, LitElement, nothing } from "lit";
import { icon } from "./icons";
import { text } from "./messages.generated";

/** The element whose explanation is shown: there is one at a time. */
let opened: Info | undefined;

/**
 * A button that shows or hides the explanation of a control beneath its row, by mouse, touch and keyboard; Escape hides
 * it. The button and the explanation are cells of the row's grid.
 */
export class Info extends LitElement {
	static override properties = { name: { attribute: false }, text: { attribute: false } };
	/** Name of the control. */
	declare name: string;
	/** The explanation. */
	declare text: string;

	readonly #id = `about-${++count}`;

	protected override createRenderRoot(): this {
		return this;
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		if (opened === this) this.#toggle();
	}

	/** Renders the button and, if it is open, the explanation. */
	protected override render(): unknown {
		const isOpen = opened === this;
		const name = text("about_control", { name: this.name });
		return html`<button
				class="info" type="button" aria-label=${name} title=${name} aria-expanded=${isOpen} aria-controls=${isOpen ? this.#id : nothing}
				@click=${this.#toggle}
			>${icon("info")}</button>
			${isOpen ? html`<p class="explanation" id=${this.#id} role="note">${this.text}</p>` : nothing}`;
	}

	readonly #toggle = (): void => {
		const before = opened;
		opened = before === this ? undefined : this;
		if (opened && !before) document.addEventListener("keydown", hideOnEscape);
		if (!opened) document.removeEventListener("keydown", hideOnEscape);
		before?.requestUpdate();
		opened?.requestUpdate();
	};

	hide(): void {
		if (opened === this) this.#toggle();
	}
}

let count = 0;

/** Hides the explanation, unless the key has another use, such as closing a dialog. */
function hideOnEscape(event: KeyboardEvent): void {
	if (event.key !== "Escape" || event.defaultPrevented || document.querySelector("dialog[open]")) return;
	event.preventDefault();
	opened?.hide();
}

customElements.define("panicle-info", Info);
