/**
 * A flat view with grips: what boundary and sun are drawn and dragged on. It shows what it is given and tells what a
 * person does to it; the document stays with the page. Subclasses say what lies behind the grips.
 */
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { classMap } from "lit/directives/class-map.js";
import type { Change } from "../../../../controls/desk";
import { type Frame, fromScreen, type Point, toScreen } from "./frame";
import { changeBy, type Grip, nearestGrip, type Pose } from "./grip";
import { gripStyle } from "./grip_style";

/** Radius within which a grip can be taken hold of, in CSS pixels: half of 44, the least for a thumb. */
const REACH = 22;

interface Held {
	readonly pointer: number;
	readonly id: string;
	/** From the pointer to the grip, so that it does not jump. */
	readonly offset: Point;
	readonly before: Change;
	/** The frame as it was: what is in hand must not move by itself. */
	readonly frame: Frame;
	target?: Point;
	/** Whether the page was told anything of this drag, and so must be told of its end. */
	told: boolean;
}

export abstract class GripView extends LitElement {
	static override styles = gripStyle;
	static override properties = { pose: { attribute: false } };
	declare pose: Pose | undefined;

	protected size = { width: 240, height: 240 };
	#held: Held | undefined;
	#scheduled = false;
	/** What a screen reader says after a key step. */
	#spoken = "";
	/** Whether the focus came from a pointer, which needs no ring to be seen. */
	#pointed = false;
	#shown: string | undefined;
	readonly #resized = new ResizeObserver(([{ contentRect }]) => {
		const { width, height } = contentRect;
		if (width === 0 || (width === this.size.width && height === this.size.height)) return;
		this.size = { width, height };
		this.requestUpdate();
	});

	/** What it is called. */
	protected abstract readonly heading: string;
	/** What keys do, for those who hear the view. */
	protected abstract readonly help: string;
	/** How the view's units lie in an element of its size. */
	protected abstract fit(): Frame;
	/** What is drawn under the grips, in CSS pixels. */
	protected abstract drawing(frame: Frame): TemplateResult;
	/** Draws on the canvas below all, where there is anything to draw. */
	protected ink(_canvas: HTMLCanvasElement, _frame: Frame): void {}

	override connectedCallback(): void {
		super.connectedCallback();
		this.#resized.observe(this);
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#resized.disconnect();
		this.#cancel();
	}

	protected override updated(): void {
		const canvas = this.shadowRoot?.querySelector("canvas");
		if (canvas && this.pose) this.ink(canvas, this.#frame);
	}

	protected override render() {
		const { pose } = this;
		if (!pose) return nothing;
		const frame = this.#frame;
		return html`<div
			class=${classMap({ field: true, dragging: this.#held !== undefined, pointed: this.#pointed })}
			role="group" aria-label=${this.heading}
			@pointerdown=${this.#onDown} @pointermove=${this.#onMove} @pointerup=${this.#onUp}
			@lostpointercapture=${this.#onUp} @pointerover=${this.#onOver} @pointerout=${this.#onBlur}
			@contextmenu=${this.#onOwnGesture} @mousedown=${this.#onOwnGesture} @dblclick=${this.#onDoubleClick}
			@click=${this.#onClick} @keydown=${this.#onKey} @focusin=${this.#onFocus} @focusout=${this.#onBlur}
		>
			<canvas aria-hidden="true"></canvas>
			<svg viewBox="0 0 ${frame.width} ${frame.height}" aria-hidden="true">${this.drawing(frame)}</svg>
			${pose.grips.map((grip) => this.#drawGrip(grip, frame))}
			<p class="spoken" id="help">${this.help}</p>
			<p class="spoken" aria-live="polite">${this.#spoken}</p>
		</div>`;
	}

	/** Its place is set as a property: a `style` attribute would need a looser content security policy. */
	#drawGrip({ id, at, label, value }: Grip, frame: Frame): TemplateResult {
		const { x, y } = toScreen(frame, at);
		const held = id === this.#held?.id;
		const words = held || id === this.#shown ? value : undefined;
		return html`<button
			type="button" class=${classMap({ grip: true, held })} data-grip=${id}
			aria-roledescription="handle" aria-label="${label}: ${value}" aria-describedby="help"
			.style=${`transform: translate(${x}px, ${y}px)`}
		>${words ? html`<span class=${x > frame.width / 2 ? "value left" : "value"}>${words}</span>` : nothing}</button>`;
	}

	get #frame(): Frame {
		return this.#held?.frame ?? this.fit();
	}

	#pointOf({ clientX, clientY }: MouseEvent): Point {
		const box = this.getBoundingClientRect();
		return fromScreen(this.#frame, clientX - box.left, clientY - box.top);
	}

	#gripAt(event: MouseEvent): Grip | undefined {
		return this.pose && nearestGrip(this.pose, this.#pointOf(event), REACH / this.#frame.scale);
	}

	#onDown(event: PointerEvent): void {
		const grip = event.button === 0 && !this.#held ? this.#gripAt(event) : undefined;
		if (!grip || !this.pose) return;
		const point = this.#pointOf(event);
		const offset = { x: grip.at.x - point.x, y: grip.at.y - point.y };
		const { pointerId: pointer } = event;
		this.#held = { pointer, id: grip.id, offset, before: this.pose.change, frame: this.fit(), told: false };
		(event.currentTarget as Element).setPointerCapture(pointer);
		this.shadowRoot?.querySelector<HTMLElement>(`[data-grip="${grip.id}"]`)?.focus({ preventScroll: true });
		this.#pointed = true;
		window.addEventListener("keydown", this.#onEscape, { capture: true });
		this.requestUpdate();
	}

	#onMove(event: PointerEvent): void {
		const held = this.#held;
		if (held?.pointer !== event.pointerId) return;
		const point = this.#pointOf(event);
		held.target = { x: point.x + held.offset.x, y: point.y + held.offset.y };
		if (this.#scheduled) return;
		this.#scheduled = true;
		requestAnimationFrame(() => {
			this.#scheduled = false;
			this.#flush();
		});
	}

	#onUp(event: PointerEvent): void {
		const held = this.#held;
		if (held?.pointer !== event.pointerId) return;
		this.#flush();
		this.#release();
		if (held.told) this.#tell("grip-change");
	}

	/** Against the pose as it is now, not as it was when the pointer moved. */
	#flush(): void {
		const held = this.#held;
		if (!held?.target || !this.pose) return;
		held.told = true;
		this.#tell("grip-input", this.pose.pull(held.id, held.target));
		held.target = undefined;
	}

	#release(): void {
		this.#held = undefined;
		window.removeEventListener("keydown", this.#onEscape, { capture: true });
		this.requestUpdate();
	}

	#cancel(): void {
		const held = this.#held;
		if (!held) return;
		this.#release();
		if (held.told) this.#step(held.before);
	}

	readonly #onEscape = (event: KeyboardEvent): void => {
		if (event.key !== "Escape") return;
		event.preventDefault();
		event.stopPropagation();
		this.#cancel();
	};

	/** No menu after a long press, no focus but the one given. */
	#onOwnGesture(event: Event): void {
		if (this.#held) event.preventDefault();
	}

	#onDoubleClick(event: MouseEvent): void {
		const grip = this.#gripAt(event);
		const change = grip && this.pose?.reset?.(grip.id);
		if (change) this.#step(change);
	}

	#onKey(event: KeyboardEvent): void {
		const id = idOf(event);
		if (id === undefined || !this.pose || this.#held || event.ctrlKey || event.metaKey || event.altKey) return;
		const change = changeBy(this.pose, id, event);
		if (!change) return;
		event.preventDefault();
		this.#pointed = false;
		this.#step(change);
		this.#show(id);
		// The new pose comes with the page's next drawing.
		requestAnimationFrame(() => this.#say(id));
	}

	/** Enter, the space bar or a screen reader presses a grip: where it stands is said. A pointer's click says nothing. */
	#onClick(event: MouseEvent): void {
		const id = idOf(event);
		if (id === undefined || event.detail > 0) return;
		this.#show(id);
		this.#say(id);
	}

	#onOver(event: PointerEvent): void {
		if (event.pointerType === "mouse") this.#show(idOf(event));
	}

	#onFocus(event: FocusEvent): void {
		const detail = idOf(event);
		if (detail) this.dispatchEvent(new CustomEvent("grip-focus", { detail, bubbles: true, composed: true }));
		if ((event.target as Element).matches(":focus-visible")) this.#show(detail);
	}

	#onBlur(event: Event): void {
		if (event.type === "focusout") this.#pointed = false;
		this.#show(undefined);
	}

	/** What is said twice is told apart by a space at its end, or the second time would not be heard. */
	#say(id: string): void {
		const words = this.pose?.grips.find((grip) => grip.id === id)?.value ?? "";
		this.#spoken = words === this.#spoken ? `${words}\u00a0` : words;
		this.requestUpdate();
	}

	#show(id: string | undefined): void {
		this.#shown = id;
		this.requestUpdate();
	}

	#step(change: Change): void {
		this.#tell("grip-input", change);
		this.#tell("grip-change");
	}

	#tell(type: "grip-input" | "grip-change", detail: Change = {}): void {
		this.dispatchEvent(new CustomEvent(type, { detail, bubbles: true, composed: true }));
	}
}

function idOf({ target }: Event): string | undefined {
	return (target as Element).closest<HTMLElement>("[data-grip]")?.dataset.grip;
}
