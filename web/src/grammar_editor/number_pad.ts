import { html, LitElement, nothing } from "lit";
import { icon } from "../ui/icons";
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

	protected override createRenderRoot(): this {
		return this;
	}

	protected override render(): unknown {
		const { number } = this;
		if (!number) return nothing;
		const button = (words: string, sign: string, steps: number) =>
			html`<button type="button" class="button" tabindex="-1" aria-label=${words} @mousedown=${keepFocus} @click=${() => this.step(steps)}>${sign}</button>`;
		return html`${button("Less", "−", -1)}
			<span
				class="number-pad" role="slider" tabindex="0" aria-label="Number at the cursor" aria-valuenow=${number.value} aria-valuetext=${number.text}
				title="Drag to change the number" @pointerdown=${this.#drag} @mousedown=${keepFocus} @keydown=${this.#press}
			>${icon("scrub")}${number.text}</span>
			${button("More", "+", 1)}`;
	}

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

	#press(event: KeyboardEvent): void {
		const steps = STEPS[event.key];
		if (steps === undefined || event.altKey) return;
		event.preventDefault();
		this.step(steps * reach(event));
	}
}

/** The cursor stays in the text, and a phone's keyboard stays open. */
function keepFocus(event: Event): void {
	event.preventDefault();
}

customElements.define("panicle-number-pad", NumberPad);
