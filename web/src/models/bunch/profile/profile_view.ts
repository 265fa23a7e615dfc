/**
 * `<panicle-profile view="front|side">`: one view of the octahedral profile with its handles (paper section 4.2,
 * figures 5 and 8). It draws what it is given and tells what a person does to it; the document stays with the page.
 */
import { html, LitElement, nothing, type PropertyValues } from "lit";
import { classMap } from "lit/directives/class-map.js";
import type { BunchSpecimen } from "../specimen";
import { type DragOptions, nearestHandle, nudgeHandle } from "./drag";
import { DragSession } from "./drag_session";
import {
	type Handle,
	handleKeys,
	handlePosition,
	handleValue,
	type Locks,
	type Point,
	VIEW_SIDES,
	type View,
} from "./handles";
import { drawGuides, drawHandle, drawOutline, drawScale, HANDLE_REACH, handleOf } from "./profile_drawing";
import { profileStyle } from "./profile_style";
import type { DrawnBunch } from "./silhouette";
import { SilhouetteDrawing } from "./silhouette_canvas";
import { SteadyExtent } from "./steady_extent";
import { type ViewFrame, viewExtent, viewFrame } from "./view_frame";

type Parameters = BunchSpecimen["parameters"];
const HELP =
	"Drag, or use the arrow keys: one pixel a step, ten with Shift. Enter says where it stands. Escape calls off a drag.";

export class ProfileView extends LitElement {
	static override styles = profileStyle;
	static override properties = {
		view: { reflect: true },
		parameters: { attribute: false },
		locks: { attribute: false },
		berries: { attribute: false },
		initial: { attribute: false },
		extent: { type: Number },
		disabled: { type: Boolean, reflect: true },
	};
	declare view: View;
	declare parameters: Parameters | undefined;
	declare locks: Locks;
	/** The bunch drawn behind; a `Grown` will do. */
	declare berries: DrawnBunch | undefined;
	/** What a double click on a handle brings back, if anything. */
	declare initial: Parameters | undefined;
	/** Side of the square shown, in pixels of the profile; chosen to suit the parameters where it is not given. */
	declare extent: number | undefined;
	declare disabled: boolean;

	#size = { width: 240, height: 240 };
	/** Whether the size is another since the last drawing. */
	#resizing = false;
	/** The handle the mouse is over or the keyboard is on: its numbers are shown. */
	#shown: Handle | undefined;
	/** What a screen reader says after a key step. */
	#spoken = "";
	/** Whether the focus came from a pointer, which needs no ring nor numbers to be seen. */
	#pointed = false;
	readonly #silhouette = new SilhouetteDrawing();
	readonly #steady = new SteadyExtent();
	#asking?: ReturnType<typeof setTimeout>;
	readonly #resized = new ResizeObserver(([{ contentRect }]) => {
		const { width, height } = contentRect;
		if (width === 0 || (width === this.#size.width && height === this.#size.height)) return;
		this.#size = { width, height };
		this.#resizing = true;
		this.requestUpdate();
	});
	readonly #drags = new DragSession<Parameters>({
		handles: () => this.#handles(),
		get: () => this.parameters as Parameters,
		input: (parameters) => this.#tell(parameters, "profile-input"),
		change: (parameters) => this.#tell(parameters, "profile-change"),
		cancel: (parameters) => this.#tell(parameters, "profile-input", "profile-cancel"),
		schedule: (callback) => requestAnimationFrame(callback),
	});

	constructor() {
		super();
		this.view = "front";
		this.locks = { leftRight: false, frontBack: false };
		this.disabled = false;
	}

	override connectedCallback(): void {
		super.connectedCallback();
		this.#resized.observe(this);
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#resized.disconnect();
		clearTimeout(this.#asking);
		this.#cancel();
	}

	protected override willUpdate(changed: PropertyValues): void {
		if (changed.has("disabled") && this.disabled) this.#cancel();
		if (!this.parameters) return;
		const wanted = this.extent ?? viewExtent(this.parameters, this.#size.width, this.#size.height);
		const motion = this.#drags.active ? "held" : changed.has("parameters") ? "moved" : "still";
		if (this.#resizing) this.#steady.forget();
		this.#resizing = false;
		const later = this.#steady.follow(wanted, motion, performance.now());
		clearTimeout(this.#asking);
		if (later !== undefined) this.#asking = setTimeout(() => this.requestUpdate(), later);
	}

	protected override render() {
		const { parameters, view, disabled } = this;
		if (!parameters) return nothing;
		const frame = this.#frame();
		const shown = this.#handles().filter((handle) => handle === this.#shown || this.#drags.holds(handle));
		return html`<div
			class=${classMap({ dragging: this.#drags.active, pointed: this.#pointed })}
			role="group"
			aria-label="Profile, ${view} view"
			@pointerdown=${this.#onPointerDown}
			@pointermove=${this.#onPointerMove}
			@pointerup=${this.#onPointerEnd}
			@lostpointercapture=${this.#onPointerEnd}
			@pointerover=${this.#onPointerOver}
			@pointerout=${this.#onPointerOut}
			@mousedown=${this.#onOwnGesture}
			@contextmenu=${this.#onOwnGesture}
			@dblclick=${this.#onDoubleClick}
			@click=${this.#onClick}
			@keydown=${this.#onKeyDown}
			@focusin=${this.#onFocusIn}
			@focusout=${this.#onFocusOut}
		>
			<canvas aria-hidden="true" @transitionend=${this.#drawBunch}></canvas>
			<svg viewBox="${frame.left} ${frame.top} ${frame.width} ${frame.height}" aria-hidden="true">
				${drawScale(this.#steady.extent, parameters.unit, frame)}
				${drawOutline(parameters, view, frame)}
				${shown.map((handle) => drawGuides(parameters, handle, frame))}
			</svg>
			${this.#handles().map((handle) =>
				drawHandle(parameters, handle, frame, { held: this.#drags.holds(handle), disabled }),
			)}
			<p class="spoken" id="help">${HELP}</p>
			<p class="spoken" aria-live="polite">${this.#spoken}</p>
		</div>`;
	}

	protected override updated(): void {
		this.#drawBunch();
	}

	#drawBunch(): void {
		const { berries: bunch, view, parameters, shadowRoot } = this;
		const canvas = shadowRoot?.querySelector("canvas");
		if (canvas && parameters)
			this.#silhouette.show(canvas, { bunch, view, unit: parameters.unit, frame: this.#frame() });
	}

	#handles(): Handle[] {
		return ["p2", ...VIEW_SIDES[this.view]];
	}

	#frame(): ViewFrame {
		return viewFrame(this.#size.width, this.#size.height, this.#steady.extent);
	}

	#tell(parameters: Parameters, ...events: string[]): void {
		this.parameters = parameters;
		for (const type of events) {
			this.dispatchEvent(new CustomEvent(type, { detail: { parameters }, bubbles: true, composed: true }));
		}
	}

	#options({ altKey }: { altKey: boolean }): DragOptions {
		return { locks: this.locks, mirror: altKey };
	}

	/** A pointer's place in pixels of the profile. */
	#point({ clientX, clientY }: MouseEvent): Point {
		const frame = this.#frame();
		const box = this.getBoundingClientRect();
		return {
			x: frame.left + ((clientX - box.left) / box.width) * frame.width,
			y: frame.top + ((clientY - box.top) / box.height) * frame.height,
		};
	}

	/** The free handle within reach of a pointer. Reaches overlap on a small bunch: the nearest is meant, not the top. */
	#handleAt(event: MouseEvent): Handle | undefined {
		const { parameters } = this;
		if (!parameters) return undefined;
		const free = this.#handles().filter((handle) => !this.#drags.holds(handle));
		const places = new Map(free.map((handle) => [handle, handlePosition(parameters, handle)]));
		return nearestHandle(places, this.#point(event), HANDLE_REACH / this.#frame().scale);
	}

	#onPointerDown(event: PointerEvent): void {
		if (this.disabled || event.button !== 0) return;
		const handle = this.#handleAt(event);
		if (!handle || !this.#drags.begin(event.pointerId, handle, this.#point(event))) return;
		(event.currentTarget as Element).setPointerCapture(event.pointerId);
		this.shadowRoot?.querySelector<HTMLElement>(`[data-handle=${handle}]`)?.focus({ preventScroll: true });
		this.#pointed = true;
		window.addEventListener("keydown", this.#onEscape, { capture: true });
		this.requestUpdate();
	}

	#onPointerMove(event: PointerEvent): void {
		this.#drags.move(event.pointerId, this.#point(event), event.shiftKey, this.#options(event));
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

	/** No menu after a long press, no focus but the one given: the handle held need not be the one whose reach is on top. */
	#onOwnGesture(event: Event): void {
		if (this.#drags.active) event.preventDefault();
	}

	#onPointerOver(event: PointerEvent): void {
		if (event.pointerType === "mouse" && !this.disabled) this.#show(handleOf(event));
	}

	/** The numbers of a handle that the mouse leaves go; those of the one the keyboard is on stay. */
	#onPointerOut(): void {
		const focused = this.#pointed ? null : this.shadowRoot?.querySelector(".handle:focus-visible");
		this.#show(focused ? handleOf({ target: focused }) : undefined);
	}

	#onFocusIn(event: FocusEvent): void {
		if ((event.target as Element).matches(":focus-visible")) this.#show(handleOf(event));
	}

	#onFocusOut(): void {
		this.#pointed = false;
		this.#show(undefined);
	}

	#onDoubleClick(event: MouseEvent): void {
		const handle = this.#handleAt(event);
		if (!handle || !this.initial || !this.parameters || this.disabled) return;
		const parameters = { ...this.parameters };
		for (const key of handleKeys(handle)) parameters[key] = this.initial[key];
		this.#tell(parameters, "profile-input", "profile-change");
	}

	#onKeyDown(event: KeyboardEvent): void {
		const handle = handleOf(event);
		if (!handle || !this.parameters || this.disabled || event.ctrlKey || event.metaKey) return;
		if (this.#drags.active) return;
		const step = event.shiftKey ? 10 : 1;
		const parameters = nudgeHandle(this.parameters, handle, event.key, step, this.#options(event));
		if (!parameters) return;
		event.preventDefault();
		this.#pointed = false;
		this.#say(handleValue(parameters, handle));
		this.#show(handle);
		this.#tell(parameters, "profile-input", "profile-change");
	}

	/** Enter, the space bar or a screen reader presses a handle: where it stands is said. A pointer's click says nothing. */
	#onClick(event: MouseEvent): void {
		const handle = handleOf(event);
		if (!handle || !this.parameters || event.detail > 0) return;
		this.#say(handleValue(this.parameters, handle));
		this.#show(handle);
	}

	/** What is said twice is told apart by a space at its end, or the second time would not be heard. */
	#say(words: string): void {
		this.#spoken = words === this.#spoken ? `${words}\u00a0` : words;
	}

	#show(handle: Handle | undefined): void {
		this.#shown = handle;
		this.requestUpdate();
	}
}

customElements.define("panicle-profile", ProfileView);
