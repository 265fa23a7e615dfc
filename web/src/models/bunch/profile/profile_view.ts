/**
 * `<panicle-profile view="front|side">`: one view of the octahedral profile with its handles (paper section 4.2,
 * figures 5 and 8). It draws its properties and reports changes as events; the page owns the document.
 */

import { html, nothing, type PropertyValues } from "lit";
import { HandleView } from "../../../ui/handles/handle_view";
import type { Point } from "../../../ui/handles/point";
import { text } from "../messages.generated";
import type { Photo } from "../photo/photo";
import type { BunchSpecimen } from "../specimen";
import { nudgeHandle } from "./drag";
import { type ProfileKeys, profileDrags } from "./drag_session";
import {
	HANDLES,
	type Handle,
	handleKeys,
	handleLabel,
	handleValue,
	type Locks,
	VIEW_SIDES,
	type View,
} from "./handles";
import { drawGuides, drawName, drawOutline, drawOwn, drawScale, handlePlace } from "./profile_drawing";
import { profileStyle } from "./profile_style";
import type { DrawnBunch } from "./silhouette";
import { SilhouetteDrawing } from "./silhouette_canvas";
import { SteadyExtent } from "./steady_extent";
import { type ViewFrame, viewExtent, viewFrame, withRoomFor } from "./view_frame";

type Parameters = BunchSpecimen["parameters"];

export class ProfileView extends HandleView<Handle, ProfileKeys> {
	static override styles = [...HandleView.styles, profileStyle];
	static override properties = {
		view: { reflect: true },
		parameters: { attribute: false },
		locks: { attribute: false },
		berries: { attribute: false },
		initial: { attribute: false },
		extent: { type: Number },
		pixels: { type: Boolean },
		photo: { attribute: false },
	};
	declare view: View;
	declare parameters: Parameters | undefined;
	declare locks: Locks;
	/** Bunch that is drawn behind; a `BunchPlant` fits. */
	declare berries: DrawnBunch | undefined;
	/** Parameters that a double click on a handle restores, if any. */
	declare initial: Parameters | undefined;
	/** Side of the visible square, in pixels of the profile; chosen by the parameters if absent. */
	declare extent: number | undefined;
	/** Whether handles' numbers include the paper's pixels. */
	declare pixels: boolean;
	/** Photograph below the view; the importer also loads its element (photo/photo_view.ts). */
	declare photo: Photo | undefined;

	protected readonly help = text("handle_help");
	readonly #silhouette = new SilhouetteDrawing();
	readonly #steady = new SteadyExtent();
	#refresh?: ReturnType<typeof setTimeout>;
	/**
	 * Parameters after the last drag in this view, until its pointer leaves: the extent stays constant that long, so that
	 * the handle stays below the pointer.
	 */
	#afterDrag: Parameters | undefined;
	protected readonly drags = profileDrags<Parameters>({
		handles: () => this.#handles(),
		locks: () => this.locks,
		get: () => this.parameters as Parameters,
		input: (parameters) => this.#showEdit(parameters),
		change: () => this.emit("profile-change"),
	});

	constructor() {
		super();
		this.addEventListener("pointerleave", this.#pointerLeft);
		this.view = "front";
		this.pixels = false;
		this.locks = { leftRight: false, frontBack: false };
	}

	/** The label of the view for screen readers. */
	protected get heading(): string {
		return text("profile_heading", { view: this.view });
	}

	/** Stops the timer when the view is removed. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		clearTimeout(this.#refresh);
	}

	/** Chooses the extent anew after a resize. */
	protected override resized(): void {
		this.#steady.forget();
	}

	/**
	 * Chooses the visible extent. It stays constant while a handle of this view is held or the profile changes in quick
	 * succession, and follows after a pause (`#steady`).
	 */
	protected override willUpdate(changed: PropertyValues): void {
		if (!this.parameters) return;
		const shape = withRoomFor(this.parameters, this.berries?.profile);
		const wantedExtent = this.extent ?? viewExtent(shape, this.size.width, this.size.height);
		if (this.drags.active) this.#afterDrag = this.parameters;
		else if (this.#afterDrag && !sameShape(this.#afterDrag, this.parameters)) this.#afterDrag = undefined;
		const motion = this.#afterDrag ? "held" : changed.has("parameters") ? "moved" : "still";
		const delay = this.#steady.follow(wantedExtent, motion, performance.now());
		clearTimeout(this.#refresh);
		if (delay !== undefined) this.#refresh = setTimeout(() => this.requestUpdate(), delay);
	}

	/** Renders the profile's outline, its measures, the handles and the photo. */
	protected inside(): unknown {
		const { parameters, view } = this;
		if (!parameters) return undefined;
		const frame = this.#frame();
		const shown = this.#handles().filter((handle) => handle === this.shown || this.drags.holds(handle));
		return html`<svg
				class="drawing" viewBox="${frame.left} ${frame.top} ${frame.width} ${frame.height}" aria-hidden="true"
			>
				${drawScale(this.#steady.extent, parameters.unit, frame)}
				${drawOutline(parameters, view, frame)}
				${this.drags.active ? nothing : drawOwn(parameters, this.berries?.profile, view)}
				${shown.map((handle) => drawGuides(parameters, handle, frame, this.pixels))}
			</svg>
			${this.photo ? html`<panicle-photo .photo=${this.photo} .frame=${frame}></panicle-photo>` : nothing}
			${this.#handles().map((handle) => {
				const content = drawName(parameters, handle, frame);
				return this.drawHandle(handle, handlePlace(parameters, handle, frame), {
					label: handleLabel(parameters, handle),
					content,
				});
			})}`;
	}

	/** Draws the grown bunch behind the handles. */
	protected override ink(canvas: HTMLCanvasElement): void {
		const { berries: bunch, view, parameters } = this;
		if (parameters) this.#silhouette.show(canvas, { bunch, view, unit: parameters.unit, frame: this.#frame() });
	}

	/** Returns the positions of the view's handles, CSS pixels. */
	protected places(): [Handle, Point][] {
		const { parameters } = this;
		return parameters ? this.#handles().map((handle) => [handle, handlePlace(parameters, handle, this.#frame())]) : [];
	}

	/** Converts a position in CSS pixels to pixels of the profile. */
	protected units({ x, y }: Point): Point {
		const { left, top, scale } = this.#frame();
		return { x: left + x / scale, y: top + y / scale };
	}

	/** Describes a handle's numbers in words. */
	protected describe(handle: Handle): string {
		return this.parameters ? handleValue(this.parameters, handle) : "";
	}

	/** Returns the modifier keys that affect drags. */
	protected override keysOf({ shiftKey, altKey }: PointerEvent): ProfileKeys {
		return { shiftKey, altKey };
	}

	/** Moves a handle by a key; returns whether the key moves it. */
	protected key(handle: Handle, { key, shiftKey, altKey }: KeyboardEvent): boolean {
		const options = { locks: this.locks, mirror: altKey };
		const parameters = this.parameters && nudgeHandle(this.parameters, handle, key, shiftKey ? 10 : 1, options);
		if (!parameters) return false;
		this.#applyEdit(parameters);
		this.announce(handleValue(parameters, handle));
		return true;
	}

	/** Restores the initial numbers of a handle after a double click. */
	protected doubled(handle: Handle | undefined): void {
		if (!handle || !this.initial || !this.parameters) return;
		const parameters = { ...this.parameters };
		for (const key of handleKeys(handle)) parameters[key] = this.initial[key];
		this.#applyEdit(parameters);
	}

	/** Runs when the pointer that released a handle has left, or its finger was lifted. */
	readonly #pointerLeft = (): void => {
		if (this.drags.active || !this.#afterDrag) return;
		this.#afterDrag = undefined;
		this.requestUpdate();
	};

	/** Returns the handles of this view. */
	#handles(): Handle[] {
		return ["p2", ...VIEW_SIDES[this.view]];
	}

	/** Returns the frame that maps pixels of the profile to the element. */
	#frame(): ViewFrame {
		return viewFrame(this.size.width, this.size.height, this.#steady.extent);
	}

	/** Shows parameters during an edit and reports them. */
	#showEdit(parameters: Parameters): void {
		this.parameters = parameters;
		this.emit("profile-input", { parameters });
	}

	/** Applies a finished edit by key or double click and reports it. */
	#applyEdit(parameters: Parameters): void {
		this.#showEdit(parameters);
		this.emit("profile-change");
	}
}

/** Returns whether two profiles agree in every number that a handle sets. */
function sameShape(one: Parameters, other: Parameters): boolean {
	return HANDLES.flatMap(handleKeys).every((key) => one[key] === other[key]);
}

customElements.define("panicle-profile", ProfileView);
