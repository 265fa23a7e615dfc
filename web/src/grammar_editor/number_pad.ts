import { html, LitElement, nothing } from "lit";
import { icon } from "../ui/icons";
import { text } from "./messages.generated";
import type { NumberAt } from "./outline";
import { reach } from "./scrub";

type Keys = Pick<MouseEvent, "shiftKey" | "ctrlKey" | "metaKey">;

const STEPS: Readonly<Record<string, number>> = {
	ArrowRight: 1,
	ArrowUp: 1,
	ArrowLeft: -1,
	ArrowDown: -1,
	PageUp: 10,
	PageDown: -10,
};

/** Control of the number at the cursor without a mouse: drag by a finger, buttons, or keys. */
export class NumberPad extends LitElement {
	static override properties = {
		number: { attribute: false },
		grip: { attribute: false },
		step: { attribute: false },
		done: { attribute: false },
	};
	declare number: NumberAt | undefined;
	/** Begins a drag and returns the function that moves the number by pixels. */
	declare grip: () => ((pixels: number, keys: Keys) => void) | undefined;
	declare step: (steps: number) => void;
	/** Ends a drag. */
	declare done: () => void;

	/** Renders into the element itself, so that the page's style applies. */
	protected override createRenderRoot(): this {
		return this;
	}

	/**
	 * Renders the number at the cursor as a draggable pad between buttons for one step less and more; nothing without a
	 * number.
	 */
	protected override render(): unknown {
		const { number } = this;
		if (!number) return nothing;
		const button = (label: string, sign: string, steps: number) =>
			html`<button type="button" class="button" tabindex="-1" aria-label=${label} @mousedown=${keepFocus} @click=${() => this.step(steps)}>${sign}</button>`;
		return html`${button(text("less"), "−", -1)}
			<span
				class="number-pad" role="slider" tabindex="0" aria-label=${text("number_at_cursor")} aria-valuenow=${number.value} aria-valuetext=${number.text}
				title=${text("number_drag")} @pointerdown=${this.#drag} @mousedown=${keepFocus} @keydown=${this.#press}
			>${icon("scrub")}${number.text}</span>
			${button(text("more"), "+", 1)}`;
	}

	/** Drags the number horizontally until the pointer is released. */
	#drag(event: PointerEvent): void {
		const move = this.grip();
		if (!move) return;
		const pad = event.currentTarget as HTMLElement;
		pad.setPointerCapture(event.pointerId);
		let last = event.clientX;
		const ended = new AbortController();
		const { signal } = ended;
		const end = () => {
			ended.abort();
			this.done();
		};
		pad.addEventListener(
			"pointermove",
			(next) => {
				move(next.clientX - last, next);
				last = next.clientX;
			},
			{ signal },
		);
		pad.addEventListener("pointerup", end, { signal });
		pad.addEventListener("pointercancel", end, { signal });
	}

	/** Changes the number by arrow and page keys. */
	#press(event: KeyboardEvent): void {
		const steps = STEPS[event.key];
		if (steps === undefined || event.altKey) return;
		event.preventDefault();
		this.step(steps * reach(event));
	}
}

/** Prevents a press from moving the focus: the cursor stays in the text, and a phone's keyboard stays open. */
function keepFocus(event: Event): void {
	event.preventDefault();
}

customElements.define("panicle-number-pad", NumberPad);
