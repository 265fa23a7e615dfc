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

	/** Listens to the host's canvas until `dispose`. */
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

	/** Moves outline and handles to a profile. */
	update(parameters: Parameters): void {
		this.#parameters = parameters;
		this.#renderer.update(parameters);
		this.#host.requestRender();
	}

	/** Sets the colours, which follow the page's theme. */
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

	/** Stops listening, and frees the graphics card's memory. */
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

	/** Begins a drag if the main button is pressed on a handle; the camera controls are disabled meanwhile. */
	readonly #onPointerDown = (event: PointerEvent): void => {
		if (event.button !== 0 || !this.#parameters) return;
		const handle = this.#handleAt(event);
		if (!handle) return;
		const freedom = visibleFreedom(handle, this.#ray(event));
		this.#freedoms.set(event.pointerId, freedom);
		const at = this.#pointInView(event, handle);
		if (!at || !this.#drags.begin(event.pointerId, handle, at)) return;
		this.#host.setControlsEnabled(false);
		this.#host.canvas.setPointerCapture(event.pointerId);
		this.#escape.listen(true);
		this.#hover(handle);
	};

	/** Moves the dragged handle; without a drag, highlights the handle under the pointer. */
	readonly #onPointerMove = (event: PointerEvent): void => {
		const handle = this.#drags.heldBy(event.pointerId);
		if (handle) {
			const at = this.#pointInView(event, handle);
			if (at) this.#drags.move(event.pointerId, at, event);
		} else if (event.buttons === 0 && event.pointerType !== "touch") {
			this.#hover(this.#handleAt(event));
		}
	};

	/** Ends the highlight when the pointer leaves the canvas. */
	readonly #onPointerLeave = (): void => {
		if (!this.#drags.active) this.#hover(undefined);
	};

	/** Ends the pointer's drag. */
	readonly #onPointerEnd = (event: PointerEvent): void => {
		if (!this.#drags.heldBy(event.pointerId)) return;
		this.#drags.end(event.pointerId);
		this.#endIfReleased();
		this.#hover(event.pointerType === "touch" ? undefined : this.#handleAt(event));
	};

	/** Cancels all drags, which restores the parameters from before them. */
	#cancel(): void {
		if (!this.#drags.active) return;
		this.#drags.cancel();
		this.#endIfReleased();
	}

	/** Enables the camera controls again when no pointer holds a handle any more. */
	#endIfReleased(): void {
		if (this.#drags.active) return;
		this.#freedoms.clear();
		this.#host.setControlsEnabled(true);
		this.#escape.listen(false);
	}

	/** Shows a handle as hovered, or none, and updates the pointer's shape. */
	#hover(handle: Handle | undefined): void {
		this.#host.canvas.style.cursor = this.#drags.active ? "grabbing" : handle ? "grab" : "";
		if (handle === this.#hovered) return;
		this.#hovered = handle;
		this.#renderer.highlight(handle);
		this.#host.requestRender();
	}

	/** Returns the free handle under a pointer. */
	#handleAt(event: PointerEvent): Handle | undefined {
		if (!this.#parameters || !this.object.visible) return undefined;
		const box = this.#host.canvas.getBoundingClientRect();
		const screenPositions = new Map<Handle, Point>();
		for (const handle of HANDLES) {
			if (this.#drags.holds(handle)) continue;
			const position = new Vector3(...handleVector(this.#parameters, handle, this.#parameters.unit));
			this.object.localToWorld(position).project(this.#host.camera);
			if (Math.abs(position.z) > 1) continue;
			screenPositions.set(handle, { x: ((position.x + 1) / 2) * box.width, y: ((1 - position.y) / 2) * box.height });
		}
		const pointer = { x: event.clientX - box.left, y: event.clientY - box.top };
		return nearest(screenPositions, pointer, event.pointerType === "touch" ? TOUCH_REACH : MOUSE_REACH);
	}

	/**
	 * Returns the pointer's position in the flat view of its handle, pixels; undefined where its ray misses the handle's
	 * plane.
	 */
	#pointInView(event: PointerEvent, handle: Handle): Point | undefined {
		const parameters = this.#parameters as Parameters;
		const freedom = this.#freedoms.get(event.pointerId) ?? "plane";
		return rayToView(parameters, handle, freedom, this.#ray(event), parameters.unit);
	}

	/** Returns the pointer's ray in the bunch's frame, metres. */
	#ray({ clientX, clientY }: PointerEvent): HandleRay {
		const box = this.#host.canvas.getBoundingClientRect();
		const x = ((clientX - box.left) / box.width) * 2 - 1;
		const y = 1 - ((clientY - box.top) / box.height) * 2;
		this.#raycaster.setFromCamera(new Vector2(x, y), this.#host.camera);
		const ray = this.#raycaster.ray.clone().applyMatrix4(new Matrix4().copy(this.object.matrixWorld).invert());
		return { origin: ray.origin.toArray(), direction: ray.direction.toArray() };
	}
}
