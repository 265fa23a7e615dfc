import { LitElement, nothing } from "lit";
import type { Studio } from "../studio";

/**
 * A part of the page: draws the studio's state and calls its actions. Parts draw into the page itself, not into shadow
 * trees, so that one style sheet, one set of ids and one order of focus serve them all.
 */
export abstract class StudioElement extends LitElement {
	static override properties = { studio: { attribute: false } };
	declare studio: Studio;

	#unsubscribe: (() => void) | undefined;

	/** Draws the state; called after every change of it, at most once a frame's worth of them. */
	protected abstract draw(studio: Studio): unknown;

	protected override createRenderRoot(): this {
		return this;
	}

	override connectedCallback(): void {
		super.connectedCallback();
		if (this.studio) this.#subscribe();
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#unsubscribe?.();
		this.#unsubscribe = undefined;
	}

	protected override willUpdate(changed: Map<PropertyKey, unknown>): void {
		if (changed.has("studio") && this.isConnected) this.#subscribe();
	}

	protected override render(): unknown {
		return this.studio ? this.draw(this.studio) : nothing;
	}

	#subscribe(): void {
		this.#unsubscribe?.();
		this.#unsubscribe = this.studio.subscribe(() => {
			if (this.concerns(this.studio)) this.requestUpdate();
		});
	}

	/** Whether a change of the state can change what is drawn; for parts of which there are many. */
	protected concerns(_studio: Studio): boolean {
		return true;
	}
}
