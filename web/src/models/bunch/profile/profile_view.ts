/**
 * `<panicle-profile view="front|side">`: one view of the octahedral profile with its handles (paper section 4.2,
 * figures 5 and 8). It draws its properties and reports changes as events; the page owns the document.
 */
import { html, nothing, type PropertyValues } from "lit";
import { HandleView } from "../../../ui/handles/handle_view";
import type { Point } from "../../../ui/handles/point";
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

	protected readonly help =
		"Drag, or use the arrow keys: one pixel a step, ten with Shift. Enter says where it stands. Escape calls off a drag.";
	readonly #silhouette = new SilhouetteDrawing();
	readonly #steady = new SteadyExtent();
	#refresh?: ReturnType<typeof setTimeout>;
	/** Parameters after a drag here, until its pointer leaves: the handle stays below it. */
	#left: Parameters | undefined;
	protected readonly drags = profileDrags<Parameters>({
		handles: () => this.#handles(),
		locks: () => this.locks,
		get: () => this.parameters as Parameters,
		input: (parameters) => this.#input(parameters),
		change: () => this.emit("profile-change"),
	});

	constructor() {
		super();
		this.addEventListener("pointerleave", this.#gone);
		this.view = "front";
		this.pixels = false;
		this.locks = { leftRight: false, frontBack: false };
	}

	protected get heading(): string {
		return `Profile, ${this.view} view`;
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		clearTimeout(this.#refresh);
	}

	protected override resized(): void {
		this.#steady.forget();
	}

	protected override willUpdate(changed: PropertyValues): void {
		if (!this.parameters) return;
		const shape = withRoomFor(this.parameters, this.berries?.profile);
		const wanted = this.extent ?? viewExtent(shape, this.size.width, this.size.height);
		if (this.drags.active) this.#left = this.parameters;
		else if (this.#left && !sameShape(this.#left, this.parameters)) this.#left = undefined;
		const motion = this.#left ? "held" : changed.has("parameters") ? "moved" : "still";
		const later = this.#steady.follow(wanted, motion, performance.now());
		clearTimeout(this.#refresh);
		if (later !== undefined) this.#refresh = setTimeout(() => this.requestUpdate(), later);
	}

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

	protected override ink(canvas: HTMLCanvasElement): void {
		const { berries: bunch, view, parameters } = this;
		if (parameters) this.#silhouette.show(canvas, { bunch, view, unit: parameters.unit, frame: this.#frame() });
	}

	protected places(): [Handle, Point][] {
		const { parameters } = this;
		return parameters ? this.#handles().map((handle) => [handle, handlePlace(parameters, handle, this.#frame())]) : [];
	}

	/** Converts to pixels of the profile. */
	protected units({ x, y }: Point): Point {
		const { left, top, scale } = this.#frame();
		return { x: left + x / scale, y: top + y / scale };
	}

	protected words(handle: Handle): string {
		return this.parameters ? handleValue(this.parameters, handle) : "";
	}

	protected override keysOf({ shiftKey, altKey }: PointerEvent): ProfileKeys {
		return { shiftKey, altKey };
	}

	protected key(handle: Handle, { key, shiftKey, altKey }: KeyboardEvent): boolean {
		const options = { locks: this.locks, mirror: altKey };
		const parameters = this.parameters && nudgeHandle(this.parameters, handle, key, shiftKey ? 10 : 1, options);
		if (!parameters) return false;
		this.#step(parameters);
		this.announce(handleValue(parameters, handle));
		return true;
	}

	/** Restores the handle's numbers. */
	protected doubled(handle: Handle | undefined): void {
		if (!handle || !this.initial || !this.parameters) return;
		const parameters = { ...this.parameters };
		for (const key of handleKeys(handle)) parameters[key] = this.initial[key];
		this.#step(parameters);
	}

	/** Runs when the pointer that released a handle has left, or its finger was lifted. */
	readonly #gone = (): void => {
		if (this.drags.active || !this.#left) return;
		this.#left = undefined;
		this.requestUpdate();
	};

	#handles(): Handle[] {
		return ["p2", ...VIEW_SIDES[this.view]];
	}

	#frame(): ViewFrame {
		return viewFrame(this.size.width, this.size.height, this.#steady.extent);
	}

	#input(parameters: Parameters): void {
		this.parameters = parameters;
		this.emit("profile-input", { parameters });
	}

	#step(parameters: Parameters): void {
		this.#input(parameters);
		this.emit("profile-change");
	}
}

function sameShape(one: Parameters, other: Parameters): boolean {
	return HANDLES.flatMap(handleKeys).every((key) => one[key] === other[key]);
}

customElements.define("panicle-profile", ProfileView);
