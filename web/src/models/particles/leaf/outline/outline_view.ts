/**
 * `<panicle-outline>`: a leaf's outline with its points, over the flat leaf. It draws what it is given and tells what a
 * person does to it; the document stays with the page.
 */
import { html, LitElement, nothing, type PropertyValues } from "lit";
import { classMap } from "lit/directives/class-map.js";
import { type FlatVeins, showOutline } from "./outline_canvas";
import { OutlineDrag } from "./outline_drag";
import { inView, type OutlineFrame, onLeaf, scaleBar, steadyFrame } from "./outline_frame";
import { ADD, LOCK, REMOVE, TURN } from "./outline_icons";
import { outlineStyle } from "./outline_style";
import { HELP, KIND_WORDS, pointInWords } from "./outline_words";
import type { OutlinePoint, OutlinePoints, Place } from "./points";
import { curveOf, nearestSpan } from "./spline";
import { inserted, pressed, removed, type Step, turned } from "./steps";

/** Within so many CSS pixels a point can be taken hold of: half of 44, the least for a thumb. */
const REACH = 22;
/** Within so many a double click means the margin. */
const MARGIN_REACH = 14;
export class OutlineView extends LitElement {
	static override styles = outlineStyle;
	static override properties = {
		points: { attribute: false },
		veins: { attribute: false },
		millimetres: { type: Number },
		mirror: { type: Boolean },
		disabled: { type: Boolean, reflect: true },
	};
	declare points: OutlinePoints | undefined;
	/** Of the last growth. */
	declare veins: FlatVeins | undefined;
	/** How long the leaf is. */
	declare millimetres: number;
	/** Whether both sides move as one. */
	declare mirror: boolean;
	declare disabled: boolean;

	#size = { width: 236, height: 300 };
	#frame: OutlineFrame | undefined;
	#chosen = 1;
	#spoken = "";
	/** Whether the focus came from a pointer, which needs no ring. */
	#pointed = false;
	readonly #resized = new ResizeObserver(([{ contentRect }]) => {
		const { width, height } = contentRect;
		if (width === 0) return;
		this.#size = { width, height };
		this.requestUpdate();
	});
	readonly #drags = new OutlineDrag({
		get: () => this.points ?? [],
		symmetry: () => this,
		input: (points) => this.#tell(points, "outline-input"),
		change: () => this.#tell([...(this.points ?? [])], "outline-change"),
		cancel: (points) => this.#tell(points, "outline-input", "outline-cancel"),
		schedule: (callback) => requestAnimationFrame(callback),
	});

	constructor() {
		super();
		this.millimetres = 100;
		this.mirror = true;
		this.disabled = false;
	}

	protected override firstUpdated(): void {
		const view = this.renderRoot.querySelector(".view");
		if (view) this.#resized.observe(view);
	}

	override connectedCallback(): void {
		super.connectedCallback();
		const view = this.renderRoot?.querySelector(".view");
		if (view) this.#resized.observe(view);
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#resized.disconnect();
		this.#cancel();
	}

	protected override willUpdate(changed: PropertyValues<this>): void {
		const before = changed.get("points");
		// Others have changed it meanwhile: what is held is another point now.
		if (this.#drags.active && before && before.length !== this.points?.length) this.#cancel();
		if (changed.has("disabled") && this.disabled) this.#cancel();
		if (!this.points) return;
		this.#chosen = Math.min(Math.max(this.#chosen, 1), this.points.length - 1);
		this.#frame = steadyFrame(this.#frame, curveOf(this.points), this.#size, this.#drags.active);
	}

	protected override render() {
		const { points } = this;
		if (!points || !this.#frame) return nothing;
		const frame = this.#frame;
		const bar = scaleBar(frame, this.millimetres);
		return html`<div
				class=${classMap({ view: true, dragging: this.#drags.active, pointed: this.#pointed })}
				role="group" aria-label="Outline"
				@pointerdown=${this.#onPointerDown} @pointermove=${this.#onPointerMove}
				@pointerup=${this.#onPointerEnd} @lostpointercapture=${this.#onPointerEnd}
				@mousedown=${this.#onOwnGesture} @contextmenu=${this.#onOwnGesture}
				@dblclick=${this.#onDoubleClick} @click=${this.#onClick} @keydown=${this.#onKeyDown}
				@focusin=${this.#onFocusIn} @focusout=${this.#onFocusOut}
			>
				<canvas aria-hidden="true" @transitionend=${this.#draw}></canvas>
				<span class="scale" aria-hidden="true" .style=${`width: ${bar.length}px`}>${bar.label}</span>
				${points.map((_, index) => (index === 0 ? nothing : this.#handle(points, index, frame)))}
				<p class="spoken" id="help">${HELP}</p>
				<p class="spoken" aria-live="polite">${this.#spoken}</p>
			</div>
			<div class="bar" role="toolbar" aria-label="Points of the outline">
				${this.#button(LOCK, "Both sides alike", () => this.dispatchEvent(new CustomEvent("outline-mirror")), this.mirror)}
				${this.#button(TURN, `Kind of point, now ${KIND_WORDS[points[this.#chosen].kind]}`, () => this.#press(turned))}
				${this.#button(ADD, "Add a point after the chosen one", () => this.#press(inserted))}
				${this.#button(REMOVE, "Remove the chosen point", () => this.#press(removed))}
			</div>`;
	}

	/** Over the canvas, as a button: one to assistive technology, and `touch-action` works. */
	#handle(points: OutlinePoints, index: number, frame: OutlineFrame) {
		const { x, y } = inView(frame, points[index]);
		const state = { handle: true, held: this.#drags.holds(index), chosen: index === this.#chosen };
		return html`<button
			type="button" class=${classMap(state)} data-point=${index} data-kind=${points[index].kind}
			tabindex=${index === this.#chosen ? 0 : -1} ?disabled=${this.disabled}
			aria-roledescription="handle" aria-label=${pointInWords(points, index)} aria-describedby="help"
			.style=${`transform: translate(${x}px, ${y}px)`}
		></button>`;
	}

	#button(drawing: unknown, label: string, click: () => void, pressed?: boolean) {
		return html`<button
			type="button" aria-label=${label} title=${label} aria-pressed=${pressed ?? nothing} ?disabled=${this.disabled} @click=${click}
		>${drawing}</button>`;
	}

	protected override updated(): void {
		this.#draw();
	}

	#draw(): void {
		const canvas = this.renderRoot.querySelector("canvas");
		const { points, veins } = this;
		if (canvas && points && this.#frame) showOutline(canvas, { curve: curveOf(points), veins, frame: this.#frame });
	}

	#tell(points: OutlinePoint[], ...events: string[]): void {
		this.points = points;
		for (const type of events) {
			this.dispatchEvent(new CustomEvent(type, { detail: { outline: points }, bubbles: true, composed: true }));
		}
	}

	/** A step of keys or buttons is told and said. */
	#take({ points, chosen, said }: Step): void {
		if (points) this.#tell(points, "outline-input", "outline-change");
		if (said) this.#say(said);
		this.#chosen = chosen;
		this.requestUpdate();
	}

	#press(step: (points: OutlinePoints, chosen: number, symmetry: { mirror: boolean }) => Step): void {
		if (this.points) this.#take(step(this.points, this.#chosen, this));
	}

	/** The chosen point takes the focus. */
	#focus(): void {
		void this.updateComplete.then(() => this.#element(this.#chosen)?.focus({ preventScroll: true }));
	}

	#element(index: number): HTMLElement | null {
		return this.renderRoot.querySelector<HTMLElement>(`[data-point="${index}"]`);
	}

	/** A pointer's place in CSS pixels from the view's corner. */
	#at({ clientX, clientY }: MouseEvent): Place {
		const box = this.renderRoot.querySelector(".view")?.getBoundingClientRect();
		return { x: clientX - (box?.left ?? 0), y: clientY - (box?.top ?? 0) };
	}

	/** The free point within reach of a pointer. Reaches overlap: the nearest is meant, not the top. */
	#pointAt(event: MouseEvent): number | undefined {
		const frame = this.#frame;
		if (!this.points || !frame) return undefined;
		const at = this.#at(event);
		const away = this.points.map((point, index) => {
			const { x, y } = inView(frame, point);
			return index === 0 || this.#drags.holds(index) ? Number.POSITIVE_INFINITY : Math.hypot(x - at.x, y - at.y);
		});
		const best = away.indexOf(Math.min(...away));
		return away[best] <= REACH ? best : undefined;
	}

	#onPointerDown(event: PointerEvent): void {
		const index = this.disabled || event.button !== 0 ? undefined : this.#pointAt(event);
		if (index === undefined || !this.#frame) return;
		if (!this.#drags.begin(event.pointerId, index, onLeaf(this.#frame, this.#at(event)))) return;
		(event.currentTarget as Element).setPointerCapture(event.pointerId);
		this.#chosen = index;
		this.#focus();
		this.#pointed = true;
		window.addEventListener("keydown", this.#onEscape, { capture: true });
	}

	#onPointerMove(event: PointerEvent): void {
		if (this.#frame) this.#drags.move(event.pointerId, onLeaf(this.#frame, this.#at(event)));
	}

	#onPointerEnd(event: PointerEvent): void {
		this.#drags.end(event.pointerId);
		this.#released();
	}

	#cancel(): void {
		this.#drags.cancel();
		this.#released();
	}

	#released(): void {
		if (!this.#drags.active) window.removeEventListener("keydown", this.#onEscape, { capture: true });
		this.requestUpdate();
	}

	readonly #onEscape = (event: KeyboardEvent): void => {
		if (event.key !== "Escape") return;
		event.preventDefault();
		event.stopPropagation();
		this.#cancel();
	};

	/** No menu after a long press, no focus but the one given. */
	#onOwnGesture(event: Event): void {
		if (this.#drags.active) event.preventDefault();
	}

	/** On a point it changes the kind, on the margin it puts a point in. */
	#onDoubleClick(event: MouseEvent): void {
		if (this.disabled || !this.points || !this.#frame) return;
		const at = onLeaf(this.#frame, this.#at(event));
		const margin = nearestSpan(this.points, at);
		const index = this.#pointAt(event);
		const onPoint = index !== undefined && this.#isOn(event, index);
		if (onPoint) this.#press(turned);
		else if (margin.distance * this.#frame.scale <= MARGIN_REACH)
			this.#take(inserted(this.points, margin.span, this, at));
	}

	/** Whether a pointer is on the dot itself: between points that are close, a double click means the margin. */
	#isOn(event: MouseEvent, index: number): boolean {
		if (!this.points || !this.#frame) return false;
		const [at, point] = [this.#at(event), inView(this.#frame, this.points[index])];
		return Math.hypot(point.x - at.x, point.y - at.y) <= 7;
	}

	#onKeyDown(event: KeyboardEvent): void {
		const { points } = this;
		if (!points || this.disabled || this.#drags.active || event.ctrlKey || event.metaKey || event.altKey) return;
		if (!(event.target as Element).closest("[data-point]")) return;
		const step = pressed(points, this.#chosen, event, this);
		if (!step) return;
		event.preventDefault();
		event.stopPropagation();
		this.#pointed = false;
		this.#take(step);
		this.#focus();
	}

	/** Enter, the space bar or a screen reader presses a point: where it stands is said. A pointer's click says nothing. */
	#onClick(event: MouseEvent): void {
		if (this.points && event.detail === 0) this.#say(pointInWords(this.points, this.#chosen));
	}

	#onFocusIn(event: FocusEvent): void {
		const index = Number((event.target as HTMLElement).dataset.point);
		if (!Number.isInteger(index) || index === this.#chosen) return;
		this.#chosen = index;
		this.requestUpdate();
	}

	#onFocusOut(): void {
		this.#pointed = false;
		this.requestUpdate();
	}

	/** What is said twice is told apart by a space at its end, or the second time would not be heard. */
	#say(words: string): void {
		this.#spoken = words === this.#spoken ? `${words}\u00a0` : words;
		this.requestUpdate();
	}
}

customElements.define("panicle-outline", OutlineView);
