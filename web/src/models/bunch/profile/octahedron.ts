/**
 * The profile in the 3-D view: the octahedron's outline and faint faces, with five handles that can be dragged as in
 * the flat views. In metres, in the bunch's frame: add `object` at the bunch's position.
 */
import { type Camera, type Group, Matrix4, Raycaster, Vector2, Vector3 } from "three";
import { EscapeKey } from "../../../ui/handles/escape_key";
import { nearest, type Point } from "../../../ui/handles/point";
import type { BunchSpecimen as Specimen } from "../specimen";
import { type ProfileDrags, profileDrags } from "./drag_session";
import { type Freedom, type HandleRay, handleVector, rayToView, visibleFreedom } from "./handle_ray";
import { HANDLES, type Handle, type Locks } from "./handles";
import { type OctahedronColours, OctahedronRenderer } from "./octahedron_renderer";

type Parameters = Specimen["parameters"];

/** Interface of the view that contains the handles. */
export interface OctahedronHost {
	readonly canvas: HTMLCanvasElement;
	readonly camera: Camera;
	requestRender(): void;
	/** Orbit, zoom and pan are disabled while a handle is held. */
	setControlsEnabled(on: boolean): void;
	/** Pairs of sides that move as one. */
	locks(): Locks;
	/**
	 * Reports changed parameters during a drag, at most once a frame; when Escape cancels it, reports the original
	 * ones.
	 */
	input(parameters: Parameters): void;
	/** Reports that a drag ended or was cancelled. */
	change(): void;
}

/** Distance within which a mouse or pen, and a finger, grab a handle, in CSS pixels. */
const MOUSE_REACH = 16;
const TOUCH_REACH = 26;

export class OctahedronHandles {
	readonly #host: OctahedronHost;
	readonly #renderer: OctahedronRenderer;
	readonly #raycaster = new Raycaster();
	/** Visible freedom of each pointer's handle. */
	readonly #freedoms = new Map<number, Freedom>();
	readonly #drags: ProfileDrags<Parameters>;
	readonly #escape = new EscapeKey(() => this.#cancel());
	#parameters?: Parameters;
	#hovered?: Handle;

	constructor(host: OctahedronHost) {
		this.#host = host;
		this.#renderer = new OctahedronRenderer(host.canvas);
		this.#drags = profileDrags<Parameters>({
			handles: () => HANDLES,
			locks: () => host.locks(),
			get: () => this.#parameters as Parameters,
			input: (parameters) => {
				this.update(parameters);
				host.input(parameters);
			},
			change: () => host.change(),
		});
		// In the capturing phase, so that the camera controls are disabled before they get the event of a pointer that
		// grabbed a handle.
		host.canvas.addEventListener("pointerdown", this.#onPointerDown, { capture: true });
		host.canvas.addEventListener("pointermove", this.#onPointerMove);
		host.canvas.addEventListener("pointerleave", this.#onPointerLeave);
		host.canvas.addEventListener("pointerup", this.#onPointerEnd);
		host.canvas.addEventListener("lostpointercapture", this.#onPointerEnd);
	}

	/** The outline, faces and handles; place it like the bunch. */
	get object(): Group {
		return this.#renderer.object;
	}

	update(parameters: Parameters): void {
		this.#parameters = parameters;
		this.#renderer.update(parameters);
		this.#host.requestRender();
	}

	setColours(colours: OctahedronColours): void {
		this.#renderer.setColours(colours);
		this.#host.requestRender();
	}

	/** Hidden handles cannot be dragged. */
	setVisible(visible: boolean): void {
		if (!visible) this.#cancel();
		this.object.visible = visible;
		if (!visible) this.#hover(undefined);
		this.#host.requestRender();
	}

	dispose(): void {
		this.setVisible(false);
		const { canvas } = this.#host;
		canvas.removeEventListener("pointerdown", this.#onPointerDown, { capture: true });
		canvas.removeEventListener("pointermove", this.#onPointerMove);
		canvas.removeEventListener("pointerleave", this.#onPointerLeave);
		canvas.removeEventListener("pointerup", this.#onPointerEnd);
		canvas.removeEventListener("lostpointercapture", this.#onPointerEnd);
		this.object.removeFromParent();
		this.#renderer.dispose();
	}

	readonly #onPointerDown = (event: PointerEvent): void => {
		if (event.button !== 0 || !this.#parameters) return;
		const handle = this.#handleAt(event);
		if (!handle) return;
		const freedom = visibleFreedom(handle, this.#ray(event));
		this.#freedoms.set(event.pointerId, freedom);
		const at = this.#point(event, handle);
		if (!at || !this.#drags.begin(event.pointerId, handle, at)) return;
		this.#host.setControlsEnabled(false);
		this.#host.canvas.setPointerCapture(event.pointerId);
		this.#escape.listen(true);
		this.#hover(handle);
	};

	readonly #onPointerMove = (event: PointerEvent): void => {
		const handle = this.#drags.heldBy(event.pointerId);
		if (handle) {
			const at = this.#point(event, handle);
			if (at) this.#drags.move(event.pointerId, at, event);
		} else if (event.buttons === 0 && event.pointerType !== "touch") {
			this.#hover(this.#handleAt(event));
		}
	};

	readonly #onPointerLeave = (): void => {
		if (!this.#drags.active) this.#hover(undefined);
	};

	readonly #onPointerEnd = (event: PointerEvent): void => {
		if (!this.#drags.heldBy(event.pointerId)) return;
		this.#drags.end(event.pointerId);
		this.#released();
		this.#hover(event.pointerType === "touch" ? undefined : this.#handleAt(event));
	};

	#cancel(): void {
		if (!this.#drags.active) return;
		this.#drags.cancel();
		this.#released();
	}

	#released(): void {
		if (this.#drags.active) return;
		this.#freedoms.clear();
		this.#host.setControlsEnabled(true);
		this.#escape.listen(false);
	}

	#hover(handle: Handle | undefined): void {
		this.#host.canvas.style.cursor = this.#drags.active ? "grabbing" : handle ? "grab" : "";
		if (handle === this.#hovered) return;
		this.#hovered = handle;
		this.#renderer.highlight(handle);
		this.#host.requestRender();
	}

	/** The free handle under a pointer. */
	#handleAt(event: PointerEvent): Handle | undefined {
		if (!this.#parameters || !this.object.visible) return undefined;
		const box = this.#host.canvas.getBoundingClientRect();
		const places = new Map<Handle, Point>();
		for (const handle of HANDLES) {
			if (this.#drags.holds(handle)) continue;
			const place = new Vector3(...handleVector(this.#parameters, handle, this.#parameters.unit));
			this.object.localToWorld(place).project(this.#host.camera);
			if (Math.abs(place.z) > 1) continue;
			places.set(handle, { x: ((place.x + 1) / 2) * box.width, y: ((1 - place.y) / 2) * box.height });
		}
		const pointer = { x: event.clientX - box.left, y: event.clientY - box.top };
		return nearest(places, pointer, event.pointerType === "touch" ? TOUCH_REACH : MOUSE_REACH);
	}

	/** Returns the pointer's position in the flat view of its handle. */
	#point(event: PointerEvent, handle: Handle): Point | undefined {
		const parameters = this.#parameters as Parameters;
		const freedom = this.#freedoms.get(event.pointerId) ?? "plane";
		return rayToView(parameters, handle, freedom, this.#ray(event), parameters.unit);
	}

	/** The pointer's ray in the bunch's frame. */
	#ray({ clientX, clientY }: PointerEvent): HandleRay {
		const box = this.#host.canvas.getBoundingClientRect();
		const x = ((clientX - box.left) / box.width) * 2 - 1;
		const y = 1 - ((clientY - box.top) / box.height) * 2;
		this.#raycaster.setFromCamera(new Vector2(x, y), this.#host.camera);
		const ray = this.#raycaster.ray.clone().applyMatrix4(new Matrix4().copy(this.object.matrixWorld).invert());
		return { origin: ray.origin.toArray(), direction: ray.direction.toArray() };
	}
}
