/** Gestures on the picture: the circle that shows the two numbers, and the driver that moves it. */

import { ARROWS } from "../../ui/handles/point";
import { KeyRuns } from "../../ui/key_runs";
import type { ToolInteraction, ToolView } from "../../ui/tool";
import type { DrivenBy, GestureState, Gestures } from "../gesture_tool";
import { text } from "../messages.generated";
import { Axes, type Axis, atShare, shareOf } from "./axis";
import { CameraDriver } from "./camera_driver";
import type { Driver, DriverEvents } from "./driver";
import { GamepadDriver } from "./gamepad_driver";
import type { Position } from "./hand";
import { acrossScreen, toTheRight } from "./lean";
import { nextPair, pairOf } from "./pair";
import { PointerDriver } from "./pointer_driver";

/** Name of the gesture in the document's history. */
const GESTURE = "gesture";
/** Distance within which the circle follows again after a new pair was selected, in shares of the picture. */
const NEAR = 0.08;

export class GestureInteraction implements ToolInteraction {
	readonly #view: ToolView;
	readonly #gestures: Gestures;
	readonly #axes: Axes;
	readonly #layer = document.createElement("div");
	readonly #circle = Object.assign(document.createElement("button"), { type: "button", className: "gesture-circle" });
	readonly #hand = Object.assign(document.createElement("span"), { className: "gesture-hand", hidden: true });
	readonly #words = Object.assign(document.createElement("span"), { className: "gesture-words" });
	/** Announces the numbers to screen readers when the device rests. */
	readonly #status = Object.assign(document.createElement("p"), { className: "unseen", role: "status" });
	readonly #runs = new KeyRuns();
	readonly #video = Object.assign(document.createElement("video"), { muted: true, playsInline: true, hidden: true });
	#driver: Driver | undefined;
	#by: DrivenBy | undefined;
	/** Whether the driver must first come near the circle before the circle follows. */
	#awaited = false;
	#moved = false;
	/** Latest position of the device since the last frame. */
	#to: Position | undefined;
	#frame = 0;
	#place: Position = { x: 0.5, y: 0.5 };
	/** Value of `#right` when the circle was placed. */
	#placedFor = 1;
	readonly #endDrawn: () => void;

	/** Adds the layer with the circle after the view's canvas; it is hidden until the tool is opened. */
	constructor(view: ToolView, gestures: Gestures) {
		this.#view = view;
		this.#gestures = gestures;
		this.#axes = new Axes(gestures.context, gestures.source, () => this.update());
		this.#layer.className = "gestures";
		this.#circle.ariaRoleDescription = text("two_way_slider");
		this.#circle.addEventListener("keydown", (event) => this.#press(event));
		this.#words.ariaHidden = "true";
		this.#hand.ariaHidden = "true";
		this.#video.ariaLabel = text("camera_picture");
		this.#layer.append(this.#video, this.#hand, this.#circle, this.#words, this.#status);
		this.#layer.hidden = true;
		view.canvas.after(this.#layer);
		// Seen from behind, a plant bends the other way on the screen.
		this.#endDrawn = view.onDrawn(() => {
			if (this.#state.open && this.#right < 0 !== this.#placedFor < 0) this.#placeCircle();
		});
	}

	/**
	 * Shows or hides the circle, starts the device of the tool's state, and moves the circle to the document's numbers.
	 */
	update(): void {
		const { open, by } = this.#state;
		this.#layer.hidden = !open;
		this.#view.keepWhole(open);
		this.#useDriver(open ? by : undefined);
		if (open) this.#placeCircle();
	}

	/** Stops the device and removes the circle. */
	dispose(): void {
		this.#useDriver(undefined);
		this.#view.keepWhole(false);
		this.#endDrawn();
		this.#layer.remove();
	}

	/** State of the tool: whether it is open, its axes and its device. */
	get #state(): GestureState {
		return this.#gestures.context.toolState(this.#gestures.tool);
	}

	/** The two axes; absent ones if the document has too few. */
	get #pair(): { readonly across?: Axis; readonly up?: Axis } {
		return pairOf(this.#axes.all, this.#state);
	}

	/** Component of the plant's right along the screen's right, −1 … 1. */
	get #right(): number {
		return toTheRight(this.#view.camera.matrixWorld);
	}

	/**
	 * Converts a share of the horizontal axis's range to the circle's horizontal position, or back; only an axis that
	 * bends a stem, seen from behind, is mirrored.
	 */
	#toScreen(across: Axis, share: number): number {
		const { leans } = this.#gestures.source ?? {};
		return across.id === `constant ${leans}` ? acrossScreen(share, this.#right) : share;
	}

	/** Moves the circle to the position of the two numbers. */
	#placeCircle(): void {
		const { across, up } = this.#pair;
		const { offsetLeft, offsetTop, clientWidth, clientHeight } = this.#view.canvas;
		this.#placedFor = this.#right;
		this.#place = { x: across ? this.#toScreen(across, shareOf(across)) : 0.5, y: up ? 1 - shareOf(up) : 0.5 };
		const { style } = this.#layer;
		style.translate = `${offsetLeft}px ${offsetTop}px`;
		style.width = `${clientWidth}px`;
		style.height = `${clientHeight}px`;
		placeElement(this.#circle, this.#place);
		placeElement(this.#words, this.#place);
		// At the top of the picture the words are below the circle, at its bottom above: they stay inside.
		this.#words.style.setProperty("--up", `${(-100 * this.#place.y).toFixed(2)}%`);
		const words = [across, up]
			.flatMap((axis) => (axis ? text("axis_value", { label: axis.label, value: axis.read }) : []))
			.join(", ");
		this.#circle.ariaLabel = words || text("nothing_to_control");
		this.#words.textContent = words;
		this.#words.classList.toggle("left", this.#place.x > 0.6);
	}

	/** Replaces the driver; undefined stops gestures. Dragging turns the plant only while the pointer does not drive. */
	#useDriver(device: DrivenBy | undefined): void {
		if (device === this.#by) return;
		this.#driver?.stop();
		this.#settle();
		this.#by = device;
		this.#awaited = false;
		this.#hand.hidden = true;
		this.#video.hidden = device !== "camera";
		this.#view.orbiting = device !== "pointer";
		this.#driver = device && this.#createDriver(device);
	}

	/** Creates the driver of a device. */
	#createDriver(device: DrivenBy): Driver {
		// Events of a stopped driver are ignored.
		const isCurrent = () => this.#by === device;
		const events: DriverEvents = {
			where: () => this.#place,
			move: (place) => isCurrent() && this.#move(place),
			rest: () => isCurrent() && this.#settle(),
			next: () => isCurrent() && this.#next(),
			report: (message) => queueMicrotask(() => isCurrent() && this.#setState({ message })),
			fail: (message) => queueMicrotask(() => isCurrent() && this.#setState({ message, by: "pointer" })),
		};
		if (device === "camera") return new CameraDriver(this.#video, events);
		return device === "gamepad" ? new GamepadDriver(events) : new PointerDriver(this.#view.canvas, events);
	}

	/** Moves the circle with the next frame, which limits growth to one request per frame. */
	#move(to: Position): void {
		if (!this.#to) this.#frame = requestAnimationFrame(() => this.#follow());
		this.#to = to;
	}

	/**
	 * Moves the circle to the latest place that the driver reported. While the circle waits for the hand, it stays until
	 * the hand comes near it.
	 */
	#follow(): void {
		const to = this.#to;
		this.#to = undefined;
		cancelAnimationFrame(this.#frame);
		if (!to) return;
		placeElement(this.#hand, to);
		if (this.#awaited && Math.hypot(to.x - this.#place.x, to.y - this.#place.y) > NEAR) return;
		this.#awaited = false;
		this.#hand.hidden = true;
		this.#setNumbers(to);
	}

	/** Sets the two numbers to a position of the circle. */
	#setNumbers({ x, y }: Position): void {
		const { across, up } = this.#pair;
		const values = new Map<string, number>();
		if (across) values.set(across.id, atShare(across, this.#toScreen(across, x)));
		if (up) values.set(up.id, atShare(up, 1 - y));
		this.#moved = true;
		this.#gestures.context.edit(this.#axes.to(values), GESTURE);
	}

	/** Ends the gesture as one undo step, and announces the values. */
	#settle(): void {
		this.#follow();
		if (!this.#moved) return;
		this.#moved = false;
		this.#gestures.context.settle(GESTURE);
		this.#announce();
	}

	/** Announces the values to screen readers. */
	#announce(): void {
		this.#status.textContent = this.#words.textContent;
	}

	/** Selects the next two numbers. They keep their values until the driver comes near the circle. */
	#next(): void {
		this.#settle();
		const { across, up } = this.#pair;
		this.#setState(nextPair(this.#axes.all, { across: across?.id, up: up?.id }));
		this.#awaited = true;
		this.#hand.hidden = false;
	}

	/** Changes the numbers by arrow keys, and goes to the next two by Page Down. */
	#press(event: KeyboardEvent): void {
		const { key, shiftKey, ctrlKey, metaKey, altKey } = event;
		const arrow = ARROWS[key];
		const { across, up } = this.#pair;
		if (ctrlKey || metaKey || altKey) return;
		if (key === "PageDown") this.#next();
		else if (arrow) {
			const axis = arrow.x === 0 ? up : across;
			if (!axis) return;
			const by = (arrow.x + arrow.y) * axis.step * (shiftKey ? 10 : 1);
			const mirrored = axis === across && this.#toScreen(axis, 0) === 1;
			const change = this.#axes.to(new Map([[axis.id, axis.value + (mirrored ? -by : by)]]));
			this.#gestures.context.edit({ ...change, run: this.#runs.press(axis.id) }, GESTURE);
			this.#gestures.context.settle(GESTURE);
			this.#announce();
		} else return;
		event.preventDefault();
		event.stopPropagation();
	}

	/** Changes the tool's state. */
	#setState(change: Partial<GestureState>): void {
		const { context, tool } = this.#gestures;
		context.setToolState(tool, { ...context.toolState(tool), ...change });
	}
}

/** Moves an element to a position, in shares of its parent. */
function placeElement({ style }: HTMLElement, { x, y }: Position): void {
	style.left = `${(100 * x).toFixed(2)}%`;
	style.top = `${(100 * y).toFixed(2)}%`;
}
