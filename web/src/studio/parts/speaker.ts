import { html } from "lit";
import type { Grown } from "../../models/bunch/grown";
import type { Studio } from "../studio";
import { bunchInWords } from "../words";
import { StudioElement } from "./studio_element";

/** A bunch is spoken of once it has stayed this long, in milliseconds: a drag is not a stream of numbers. */
const SETTLED = 700;

/** Tells a screen reader what has grown. */
export class Speaker extends StudioElement {
	static override properties = { ...StudioElement.properties, words: { state: true } };
	declare private words: string | undefined;

	#spokenOf: Grown | undefined;
	#timer: ReturnType<typeof setTimeout> | undefined;

	protected override draw({ state }: Studio): unknown {
		if (state.grown !== this.#spokenOf) this.#wait(state.grown);
		return html`<p class="unseen" role="status" aria-live="polite">${this.words}</p>`;
	}

	#wait(grown: Grown | undefined): void {
		this.#spokenOf = grown;
		clearTimeout(this.#timer);
		this.#timer = setTimeout(() => {
			const { grownFrom } = this.studio.state;
			if (grown && grownFrom) this.words = bunchInWords(grown, grownFrom);
		}, SETTLED);
	}
}

customElements.define("panicle-speaker", Speaker);
