/**
 * Base class of flat views with draggable handles, with pointer, keyboard and screen reader support. Subclasses define
 * the drawing, the handles' positions, and the effect of moving them; the page owns the document.
 */
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { classMap } from "lit/directives/class-map.js";
import { KeyRuns } from "../key_runs";
import { text } from "../messages.generated";
import type { DragSession } from "./drag_session";
import { EscapeKey } from "./escape_key";
import { handleStyle } from "./handle_style";
import { nearest, type Point } from "./point";

/** Radius of a handle's hit area, in CSS pixels: half of 44, the least for touch. */
const REACH = 22;

/** Drag session with any state. */
type Drags<H, K> = Pick<DragSession<H, unknown, K>, "active" | "holds" | "begin" | "move" | "end" | "cancel" | "drop">;

export interface HandleLook {
	label: string;
	/** Content of the button: a name, numbers. */
	content?: unknown;
	classes?: Readonly<Record<string, boolean>>;
	kind?: string;
	/** Whether the handle is a stop of the Tab key. */
	tab?: boolean;
	/** Ids of elements that describe its keys. */
	help?: string;
}

/** H: names of handles. K: modifier keys held during a drag. */
export abstract class HandleView<H extends string, K = undefined> extends LitElement {
	static override styles = [handleStyle];

	/** Size of the field that contains the handles, CSS pixels. */
	protected size = { width: 240, height: 240 };
	/** The handle under the mouse, or with the keyboard focus. */
	protected shown: H | undefined;
	/** Announcement to screen readers after a key step. */
	#spoken = "";
	/** Whether the focus came from a pointer, which needs neither a focus ring nor numbers. */
	#pointed = false;
	#observed: Element | null = null;
	readonly #runs = new KeyRuns();
	/** Current run of key presses. */
	#run: string | undefined;
	readonly #escape = new EscapeKey(() => this.cancel());
	readonly #resized = new ResizeObserver(([{ contentRect }]) => {
		const { width, height } = contentRect;
		if (width === 0 || (width === this.size.width && height === this.size.height)) return;
		this.size = { width, height };
		this.resized();
		this.requestUpdate();
	});

	/** Accessible name of the view. */
	protected abstract readonly heading: string;
	/** Description of the keys, for screen readers. */
	protected abstract readonly help: string;
	protected abstract readonly drags: Drags<H, K>;

	/** Returns the drawing and the handles; undefined if there is nothing to show. */
	protected abstract inside(): unknown;
	/** Returns the handles' positions, in CSS pixels from the field's corner. */
	protected abstract places(): Iterable<readonly [H, Point]>;
	/** Converts a position in CSS pixels from the field's corner to the view's own units. */
	protected abstract units(place: Point): Point;
	/** Returns a handle's position as text. */
	protected abstract describe(handle: H): string;
	/**
	 * Handles a key on a handle.
	 * @returns whether the key had an effect
	 */
	protected abstract key(handle: H, event: KeyboardEvent): boolean;
	/** Handles a double click, with the handle within reach if there is one. */
	protected abstract doubled(handle: H | undefined, at: Point): void;
	/** Returns the modifier keys that drags here distinguish. */
	protected keysOf(_event: PointerEvent): K | undefined {
		return undefined;
	}
	/** Called when a handle gets the focus. */
	protected focused(_handle: H): void {}
	/** Called when the field's size has changed. */
	protected resized(): void {}
	/** Renders content below the field; nothing here. */
	protected below(): unknown {
		return nothing;
	}
	/** Draws on the canvas below all other elements. */
	protected ink(_canvas: HTMLCanvasElement): void {}

	/** Begins to observe the field's size. */
	override connectedCallback(): void {
		super.connectedCallback();
		this.#observe();
	}

	/** Ends observing, and cancels drags. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#resized.disconnect();
		this.#observed = null;
		this.cancel();
	}

	/** Renders the drawing with its handles, or nothing where `inside` has nothing to show. */
	protected override render() {
		const inside = this.inside();
		if (inside === undefined) return nothing;
		return html`<div
			class=${classMap({ field: true, dragging: this.drags.active, pointed: this.#pointed })}
			role="group" aria-label=${this.heading}
			@pointerdown=${this.#onDown} @pointermove=${this.#onMove}
			@pointerup=${this.#onUp} @lostpointercapture=${this.#onUp}
			@pointerover=${this.#onOver} @pointerout=${this.#onOut}
			@mousedown=${this.#onOwnGesture} @contextmenu=${this.#onOwnGesture}
			@dblclick=${this.#onDoubleClick} @click=${this.#onClick} @keydown=${this.#onKey}
			@focusin=${this.#onFocus} @focusout=${this.#onBlur}
		>
			<canvas aria-hidden="true" @transitionend=${this.#ink}></canvas>
			${inside}
			<p class="spoken" id="help">${this.help}</p>
			<p class="spoken" aria-live="polite">${this.#spoken}</p>
		</div>${this.below()}`;
	}

	/** Observes a new field, and draws the canvas. */
	protected override updated(): void {
		this.#observe();
		this.#ink();
	}

	/**
	 * Draws one handle, over the drawing and not in it: `touch-action` has no effect on SVG shapes, and assistive
	 * technology recognises a button. 44 pixels across, with the dot in its middle. The position is set as a property,
	 * because a `style` attribute would need a looser content security policy.
	 */
	protected drawHandle(handle: H, { x, y }: Point, look: HandleLook): TemplateResult {
		const { label, content = nothing, classes, kind, tab = true, help = "help" } = look;
		return html`<button
			type="button" class=${classMap({ handle: true, held: this.drags.holds(handle), ...classes })}
			data-handle=${handle} data-kind=${kind ?? nothing} tabindex=${tab ? nothing : -1}
			aria-roledescription=${text("handle")} aria-label=${label} aria-describedby=${help}
			.style=${`transform: translate(${x}px, ${y}px)`}
		>${content}</button>`;
	}

	/** Dispatches an event; during a key press, its detail includes the run of presses (editor_context.ts). */
	protected emit(type: string, detail?: unknown): void {
		const told = this.#run !== undefined && detail instanceof Object ? { ...detail, run: this.#run } : detail;
		this.dispatchEvent(new CustomEvent(type, { detail: told, bubbles: true, composed: true }));
	}

	/**
	 * Announces a text to screen readers. A repeated announcement ends with a space, else it would not be read again.
	 */
	protected announce(text: string): void {
		this.#spoken = text === this.#spoken ? `${text}\u00a0` : text;
		this.requestUpdate();
	}

	/** Shows the numbers of a handle; undefined hides them. */
	protected show(handle: H | undefined): void {
		if (handle === this.shown) return;
		this.shown = handle;
		this.requestUpdate();
	}

	/** Cancels the drags in progress. */
	protected cancel(): void {
		this.drags.cancel();
		this.#afterRelease();
	}

	/** Ends the drags in progress, because their handles no longer exist. */
	protected drop(): void {
		this.drags.drop();
		this.#afterRelease();
	}

	/** Returns the button of a handle; null if it is not drawn. */
	protected element(handle: H): HTMLElement | null {
		return this.renderRoot.querySelector<HTMLElement>(`[data-handle="${handle}"]`);
	}

	/** The element that contains the handles; null before the first drawing. */
	get #field(): HTMLElement | null {
		return this.renderRoot?.querySelector<HTMLElement>(".field") ?? null;
	}

	/** Observes the field's size; the field exists after the first drawing. */
	#observe(): void {
		const field = this.isConnected ? this.#field : null;
		if (!field || field === this.#observed) return;
		this.#observed = field;
		this.#resized.observe(field);
	}

	/** Draws on the canvas, if the view has one. */
	#ink(): void {
		const canvas = this.renderRoot.querySelector("canvas");
		if (canvas) this.ink(canvas);
	}

	/** Returns a pointer's position in CSS pixels from the field's corner. */
	#positionOf({ clientX, clientY }: MouseEvent): Point {
		const box = this.#field?.getBoundingClientRect();
		return { x: clientX - (box?.left ?? 0), y: clientY - (box?.top ?? 0) };
	}

	/** Returns the handle within reach of a pointer that is not dragged yet. */
	#handleAt(event: MouseEvent): H | undefined {
		const free = [...this.places()].filter(([handle]) => !this.drags.holds(handle));
		return nearest(free, this.#positionOf(event), REACH);
	}

	/** Begins a drag if the main button is pressed on a handle. */
	#onDown(event: PointerEvent): void {
		const handle = event.button !== 0 ? undefined : this.#handleAt(event);
		if (handle === undefined) return;
		if (!this.drags.begin(event.pointerId, handle, this.units(this.#positionOf(event)))) return;
		(event.currentTarget as Element).setPointerCapture(event.pointerId);
		this.element(handle)?.focus({ preventScroll: true });
		this.#pointed = true;
		this.#escape.listen(true);
		this.requestUpdate();
	}

	/** Moves the handle that the pointer drags. */
	#onMove(event: PointerEvent): void {
		this.drags.move(event.pointerId, this.units(this.#positionOf(event)), this.keysOf(event));
	}

	/** Ends the pointer's drag. */
	#onUp(event: PointerEvent): void {
		this.drags.end(event.pointerId);
		this.#afterRelease();
	}

	/** Stops listening for Escape when no handle is held any more. */
	#afterRelease(): void {
		if (!this.drags.active) this.#escape.listen(false);
		this.requestUpdate();
	}

	/**
	 * Prevents the menu after a long press and the browser's own focus: the dragged handle need not be the topmost
	 * one.
	 */
	#onOwnGesture(event: Event): void {
		if (this.drags.active) event.preventDefault();
	}

	/** Passes a double click to the view, with the handle within reach. */
	#onDoubleClick(event: MouseEvent): void {
		this.doubled(this.#handleAt(event), this.#positionOf(event));
	}

	/**
	 * Passes a key to the focused handle; presses of the same handle within a short time are one undo step (`KeyRuns`).
	 */
	#onKey(event: KeyboardEvent): void {
		const handle = handleOf<H>(event);
		if (handle === undefined || this.drags.active || event.ctrlKey || event.metaKey) return;
		this.#run = this.#runs.press(handle);
		const done = this.key(handle, event);
		this.#run = undefined;
		if (!done) return;
		event.preventDefault();
		this.#pointed = false;
		this.show(handle);
	}

	/**
	 * Announces a handle's position when Enter, the space bar or a screen reader presses it; a pointer's click
	 * announces nothing.
	 */
	#onClick(event: MouseEvent): void {
		const handle = handleOf<H>(event);
		if (handle === undefined || event.detail > 0) return;
		this.announce(this.describe(handle));
		this.show(handle);
	}

	/** Shows the numbers of the handle under the mouse. */
	#onOver(event: PointerEvent): void {
		if (event.pointerType === "mouse") this.show(handleOf<H>(event));
	}

	/** Hides the numbers of the handle that the mouse leaves; those of the focused handle stay. */
	#onOut(): void {
		const target = this.#pointed ? null : this.renderRoot.querySelector(".handle:focus-visible");
		this.show(handleOf<H>({ target }));
	}

	/** Shows the numbers of the handle that gets the focus by the keyboard. */
	#onFocus(event: FocusEvent): void {
		const handle = handleOf<H>(event);
		if (handle === undefined) return;
		this.focused(handle);
		if ((event.target as Element).matches(":focus-visible")) this.show(handle);
	}

	/** Hides the numbers of the handle that loses the focus. */
	#onBlur(): void {
		this.#pointed = false;
		this.show(undefined);
		this.requestUpdate();
	}
}

/** Returns the handle of an event; undefined if the event is on none. */
function handleOf<H extends string>({ target }: { target: EventTarget | null }): H | undefined {
	return (target as Element | null)?.closest<HTMLElement>("[data-handle]")?.dataset.handle as H | undefined;
}
