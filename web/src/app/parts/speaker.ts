import { html } from "lit";
import type { Studio } from "../studio";
import type { ShownPlant } from "../studio_state";
import { StudioPart } from "./studio_part";

/** Time that a plant stays before it is announced, milliseconds: a drag must not cause a stream of numbers. */
const SETTLED = 700;

/** Announces the plant to screen readers. */
export class Speaker extends StudioPart {
	#words: string | undefined;
	#spokenOf: ShownPlant | undefined;
	#timer: ReturnType<typeof setTimeout> | undefined;

	protected override shows({ state }: Studio): readonly unknown[] {
		return [state.shown];
	}

	protected override draw({ state }: Studio): unknown {
		if (state.shown !== this.#spokenOf) this.#wait(state.shown);
		return html`<p class="unseen" role="status" aria-live="polite">${this.#words}</p>`;
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		clearTimeout(this.#timer);
	}

	#wait(shown: ShownPlant | undefined): void {
		this.#spokenOf = shown;
		clearTimeout(this.#timer);
		this.#timer = setTimeout(() => {
			this.#words = shown?.model.words(shown.grown, shown.from);
			this.requestUpdate();
		}, SETTLED);
	}
}

customElements.define("panicle-speaker", Speaker);
