import { LitElement, type PropertyValues } from "lit";
import type { Desk } from "./desk";

/** How many there have been, so that the ids in each are its own. */
let made = 0;

/**
 * A part of the page, or a control (control_element.ts): draws the desk's state and calls its actions. Such elements draw into the page
 * itself, not into shadow trees, so that one style sheet and one order of focus serve them all.
 */
export abstract class DeskElement<D extends Desk = Desk> extends LitElement {
	static override properties = { desk: { attribute: false } };
	declare desk: D;

	readonly #serial = ++made;
	#unsubscribe: (() => void) | undefined;

	/** Draws the state; called after every change of it, at most once a frame's worth of them. */
	protected abstract draw(desk: D): unknown;

	/** An id that no other element of the page has. */
	protected idOf(name: string): string {
		return `${name}-${this.#serial}`;
	}

	protected override createRenderRoot(): this {
		return this;
	}

	override connectedCallback(): void {
		super.connectedCallback();
		if (this.desk) this.#subscribe();
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#unsubscribe?.();
		this.#unsubscribe = undefined;
	}

	protected override willUpdate(changed: PropertyValues): void {
		if (changed.has("desk") && this.isConnected) this.#subscribe();
	}

	/** Elements of the page stand there before there is a desk. */
	protected override shouldUpdate(_changed: PropertyValues): boolean {
		return this.desk !== undefined;
	}

	protected override render(): unknown {
		return this.draw(this.desk);
	}

	#subscribe(): void {
		this.#unsubscribe?.();
		this.#unsubscribe = this.desk.subscribe(() => {
			if (this.concerns(this.desk)) this.requestUpdate();
		});
	}

	/** Whether a change of the state can change what is drawn; for elements of which there are many. */
	protected concerns(_desk: D): boolean {
		return true;
	}
}
