import { html } from "lit";
import type { Studio } from "../studio";
import type { ShownPlant } from "../studio_state";
import { StudioPart } from "./studio_part";

/** Time that a plant stays before it is announced, milliseconds: a drag must not cause a stream of numbers. */
const SETTLED = 700;

/** Announces the plant to screen readers. */
export class Speaker extends StudioPart {
	#summary: string | undefined;
	#spokenOf: ShownPlant | undefined;
	#timer: ReturnType<typeof setTimeout> | undefined;

	/** Returns the values whose change may cause an announcement. */
	protected override shows({ state }: Studio): readonly unknown[] {
		return [state.shown];
	}

	/** Renders the announcement, which follows the plant after a pause. */
	protected override draw({ state }: Studio): unknown {
		if (state.shown !== this.#spokenOf) this.#announceLater(state.shown);
		return html`<p class="unseen" role="status" aria-live="polite">${this.#summary}</p>`;
	}

	/** Stops the timer. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		clearTimeout(this.#timer);
	}

	/** Announces a plant once it has stayed for SETTLED milliseconds. */
	#announceLater(shown: ShownPlant | undefined): void {
		this.#spokenOf = shown;
		clearTimeout(this.#timer);
		this.#timer = setTimeout(() => {
			this.#summary = shown?.model.summary(shown.grown, shown.from);
			this.requestUpdate();
		}, SETTLED);
	}
}

customElements.define("panicle-speaker", Speaker);
