import { LitElement, type PropertyValues } from "lit";
import { changed } from "./changed";
import type { EditorContext } from "./editor_context";

/** Number of elements created, for unique ids. */
let made = 0;

/**
 * Base class of the page's parts and controls (control_element.ts): draws the editor's state and calls its actions.
 * Elements draw into the page itself, not into shadow trees, so that one style sheet and one focus order serve all of
 * them.
 */
export abstract class EditorElement<D extends EditorContext = EditorContext> extends LitElement {
	static override properties = { context: { attribute: false } };
	declare context: D;

	readonly #serial = ++made;
	#unsubscribe: (() => void) | undefined;
	/** Values of `shows` at the last drawing. */
	#shown: readonly unknown[] | undefined;
	/** Whether a comparison of `shows` is scheduled for the end of the current task. */
	#isComparing = false;

	/** Draws the element; called after changes of its state, once for all changes of a task. */
	protected abstract draw(context: D): unknown;

	/**
	 * Returns all values that the drawing depends on, always in the same number and order: if all are unchanged, the
	 * element is not drawn again. If absent, every change of the state draws it.
	 */
	protected shows?(context: D): readonly unknown[];

	/** Returns an id that is unique in the page. */
	protected idOf(name: string): string {
		return `${name}-${this.#serial}`;
	}

	/** Renders into the element itself, so that the page's style applies. */
	protected override createRenderRoot(): this {
		return this;
	}

	/** Begins to follow the page's state. */
	override connectedCallback(): void {
		super.connectedCallback();
		if (this.context) this.#subscribe();
	}

	/** Ends following the page's state. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#unsubscribe?.();
		this.#unsubscribe = undefined;
	}

	/** Follows the state of a new context. */
	protected override willUpdate(changed: PropertyValues): void {
		if (changed.has("context") && this.isConnected) this.#subscribe();
	}

	/** Returns whether the element can be drawn: elements may be in the page before they have a context. */
	protected override shouldUpdate(_changed: PropertyValues): boolean {
		return this.context !== undefined;
	}

	/** Draws the element, and notes the values that the drawing depends on. */
	protected override render(): unknown {
		this.#shown = this.shows?.(this.context);
		return this.draw(this.context);
	}

	/** Listens to changes of the state; many changes of one task are compared once. */
	#subscribe(): void {
		this.#unsubscribe?.();
		this.#unsubscribe = this.context.subscribe(() => {
			if (this.#isComparing) return;
			this.#isComparing = true;
			queueMicrotask(() => this.#compareShown());
		});
	}

	/** Draws the element again if a value of `shows` has changed. */
	#compareShown(): void {
		this.#isComparing = false;
		if (!this.#shown || changed(this.#shown, this.shows?.(this.context))) this.requestUpdate();
	}
}
