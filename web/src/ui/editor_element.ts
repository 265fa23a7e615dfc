import { LitElement, type PropertyValues } from "lit";
import { changed } from "./changed";
import type { EditorContext } from "./editor_context";

/** How many there have been, so that the ids in each are its own. */
let made = 0;

/**
 * A part of the page, or a control (control_element.ts): draws the editor's state and calls its actions. Such elements draw into the page
 * itself, not into shadow trees, so that one style sheet and one order of focus serve them all.
 */
export abstract class EditorElement<D extends EditorContext = EditorContext> extends LitElement {
	static override properties = { context: { attribute: false } };
	declare context: D;

	readonly #serial = ++made;
	#unsubscribe: (() => void) | undefined;
	/** Values of `shows` at the last drawing. */
	#shown: readonly unknown[] | undefined;
	/** Whether a comparison of `shows` is scheduled for the end of the current task. */
	#looking = false;

	/** Draws the element; called after changes of its state, once for all changes of a task. */
	protected abstract draw(context: D): unknown;

	/**
	 * All that is drawn of the editor's state, piece by piece, always as many in the same order: where each is the same as when it was last
	 * drawn, it is not drawn anew. Where absent, every change of the state counts.
	 */
	protected shows?(context: D): readonly unknown[];

	/** An id that no other element of the page has. */
	protected idOf(name: string): string {
		return `${name}-${this.#serial}`;
	}

	protected override createRenderRoot(): this {
		return this;
	}

	override connectedCallback(): void {
		super.connectedCallback();
		if (this.context) this.#subscribe();
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#unsubscribe?.();
		this.#unsubscribe = undefined;
	}

	protected override willUpdate(changed: PropertyValues): void {
		if (changed.has("context") && this.isConnected) this.#subscribe();
	}

	/** Elements of the page stand there before they have a context. */
	protected override shouldUpdate(_changed: PropertyValues): boolean {
		return this.context !== undefined;
	}

	protected override render(): unknown {
		this.#shown = this.shows?.(this.context);
		return this.draw(this.context);
	}

	#subscribe(): void {
		this.#unsubscribe?.();
		this.#unsubscribe = this.context.subscribe(() => {
			if (this.#looking) return;
			this.#looking = true;
			queueMicrotask(() => this.#look());
		});
	}

	/** One look at all changes that come together. */
	#look(): void {
		this.#looking = false;
		if (!this.#shown || changed(this.#shown, this.shows?.(this.context))) this.requestUpdate();
	}
}
