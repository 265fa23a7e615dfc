import { css, html, LitElement } from "lit";
import type { Point } from "../../../ui/handles/point";
import { text } from "../messages.generated";
import type { ViewFrame } from "../profile/view_frame";
import { nudged, type Photo, type Placement, pinched, shifted, zoomed } from "./photo";

/** Pixels of the mouse wheel that scale a photograph by Euler's number. */
const WHEEL_PIXELS = 600;

/** `<panicle-photo>`: a photograph on a canvas below a flat view, moved by pointer and keys while it is movable. */
export class PhotoView extends LitElement {
	static override styles = css`
		:host {
			position: absolute;
			inset: 0;
			pointer-events: none;
		}
		canvas {
			position: absolute;
			inset: 0;
			z-index: -1;
			width: 100%;
			height: 100%;
			pointer-events: none;
		}
		div {
			position: absolute;
			inset: 0;
			outline-offset: -2px;
			cursor: move;
			pointer-events: auto;
			touch-action: none;
		}
	`;
	static override properties = { photo: { attribute: false }, frame: { attribute: false } };
	declare photo: Photo;
	declare frame: ViewFrame;
	/** Positions of the pointers that hold it, in pixels of the profile. */
	readonly #held = new Map<number, Point>();

	/** Renders the canvas and, for a movable photograph, the element that receives pointer and keys. */
	protected override render(): unknown {
		const grip = html`<div
			tabindex="0" role="application" aria-label=${text("photo_handle")}
			@pointerdown=${this.#down} @pointermove=${this.#move} @pointerup=${this.#up} @lostpointercapture=${this.#up}
			@wheel=${this.#wheel} @keydown=${this.#key}
		></div>`;
		return html`<canvas aria-hidden="true"></canvas>${this.photo.loose ? grip : ""}`;
	}

	/** Draws the photo at the resolution of the screen; places are in the frame's units. */
	protected override updated(): void {
		const { frame, photo } = this;
		const canvas = this.renderRoot.querySelector("canvas");
		const pen = canvas?.getContext("2d");
		if (!canvas || !pen) return;
		const zoom = frame.scale * devicePixelRatio;
		canvas.width = Math.round(frame.width * zoom);
		canvas.height = Math.round(frame.height * zoom);
		pen.setTransform(zoom, 0, 0, zoom, -frame.left * zoom, -frame.top * zoom);
		pen.globalAlpha = photo.opacity;
		pen.imageSmoothingQuality = "high";
		const { picture, x, y, scale } = photo;
		pen.drawImage(picture, x, y, picture.width * scale, picture.height * scale);
	}

	/** Returns a pointer's position in pixels of the profile. */
	#pointerPlace({ clientX, clientY }: MouseEvent): Point {
		const { left, top } = this.getBoundingClientRect();
		const { frame } = this;
		return { x: frame.left + (clientX - left) / frame.scale, y: frame.top + (clientY - top) / frame.scale };
	}

	/** Reports a new placement of the photograph. */
	#emit(placement: Placement): void {
		this.dispatchEvent(new CustomEvent("photo-input", { detail: placement, bubbles: true, composed: true }));
	}

	/** Starts to move the photograph; a second pointer starts to scale it. */
	#down(event: PointerEvent): void {
		if (event.button !== 0 || this.#held.size > 1) return;
		// Stops the event before handles nearby take it.
		event.stopPropagation();
		(event.currentTarget as Element).setPointerCapture(event.pointerId);
		this.#held.set(event.pointerId, this.#pointerPlace(event));
	}

	/** Moves the photo with one pointer, or scales and moves it with two. */
	#move(event: PointerEvent): void {
		const before = this.#held.get(event.pointerId);
		if (!before) return;
		event.stopPropagation();
		const at = this.#pointerPlace(event);
		const [other] = [...this.#held].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
		this.#held.set(event.pointerId, at);
		if (other) this.#emit(pinched(this.photo, [before, other], [at, other]));
		else this.#emit(shifted(this.photo, { x: at.x - before.x, y: at.y - before.y }));
	}

	/** Ends the pointer's movement. */
	#up(event: PointerEvent): void {
		this.#held.delete(event.pointerId);
	}

	/** Scales the photograph about the pointer. */
	#wheel(event: WheelEvent): void {
		event.preventDefault();
		this.#emit(zoomed(this.photo, Math.exp(-event.deltaY / WHEEL_PIXELS), this.#pointerPlace(event)));
	}

	/** Moves or scales the photograph by a key. */
	#key(event: KeyboardEvent): void {
		if (event.ctrlKey || event.metaKey || event.altKey) return;
		const placement = nudged(this.photo, event);
		if (!placement) return;
		event.preventDefault();
		event.stopPropagation();
		this.#emit(placement);
	}
}

customElements.define("panicle-photo", PhotoView);
