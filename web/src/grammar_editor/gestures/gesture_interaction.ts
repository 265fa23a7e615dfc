/** Gestures on the picture: the circle that shows the two numbers, and the driver that moves it. */

import { ARROWS } from "../../ui/handles/point";
import { KeyRuns } from "../../ui/key_runs";
import type { ToolInteraction, ToolView } from "../../ui/tool";
import type { DrivenBy, GestureState, Gestures } from "../gesture_tool";
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

	constructor(view: ToolView, gestures: Gestures) {
		this.#view = view;
		this.#gestures = gestures;
		this.#axes = new Axes(gestures.context, gestures.source, () => this.update());
		this.#layer.className = "gestures";
		this.#circle.ariaRoleDescription = "two-way slider";
		this.#circle.addEventListener("keydown", (event) => this.#press(event));
		this.#words.ariaHidden = "true";
		this.#hand.ariaHidden = "true";
		this.#video.ariaLabel = "What the camera sees";
		this.#layer.append(this.#video, this.#hand, this.#circle, this.#words, this.#status);
		this.#layer.hidden = true;
		view.canvas.after(this.#layer);
		// Seen from behind, a plant bends the other way on the screen.
		this.#endDrawn = view.onDrawn(() => {
			if (this.#state.open && this.#right < 0 !== this.#placedFor < 0) this.#placeCircle();
		});
	}

	update(): void {
		const { open, by } = this.#state;
		this.#layer.hidden = !open;
		this.#view.keepWhole(open);
		this.#drive(open ? by : undefined);
		if (open) this.#placeCircle();
	}

	dispose(): void {
		this.#drive(undefined);
		this.#view.keepWhole(false);
		this.#endDrawn();
		this.#layer.remove();
	}

	get #state(): GestureState {
		return this.#gestures.context.toolState(this.#gestures.tool);
	}

	get #pair(): { readonly across?: Axis; readonly up?: Axis } {
		return pairOf(this.#axes.all, this.#state);
	}

	/** Component of the plant's right along the screen's right, −1 … 1. */
	get #right(): number {
		return toTheRight(this.#view.camera.matrixWorld);
	}

	/** Converts between the share of the number and the horizontal position of the circle, in both directions. */
	#mirrored(across: Axis, share: number): number {
		const { leans } = this.#gestures.source ?? {};
		return across.id === `constant ${leans}` ? acrossScreen(share, this.#right) : share;
	}

	/** Moves the circle to the position of the two numbers. */
	#placeCircle(): void {
		const { across, up } = this.#pair;
		const { offsetLeft, offsetTop, clientWidth, clientHeight } = this.#view.canvas;
		this.#placedFor = this.#right;
		this.#place = { x: across ? this.#mirrored(across, shareOf(across)) : 0.5, y: up ? 1 - shareOf(up) : 0.5 };
		const { style } = this.#layer;
		style.translate = `${offsetLeft}px ${offsetTop}px`;
		style.width = `${clientWidth}px`;
		style.height = `${clientHeight}px`;
		putAt(this.#circle, this.#place);
		putAt(this.#words, this.#place);
		const words = [across, up].flatMap((axis) => (axis ? `${axis.label} ${axis.read}` : [])).join(", ");
		this.#circle.ariaLabel = words || "Nothing to drive";
		this.#words.textContent = words;
		this.#words.classList.toggle("left", this.#place.x > 0.6);
	}

	#drive(by: DrivenBy | undefined): void {
		if (by === this.#by) return;
		this.#driver?.stop();
		this.#rest();
		this.#by = by;
		this.#awaited = false;
		this.#hand.hidden = true;
		this.#video.hidden = by !== "camera";
		this.#view.orbiting = by !== "pointer";
		this.#driver = by && this.#made(by);
	}

	#made(by: DrivenBy): Driver {
		// Events of a stopped driver are ignored.
		const mine = () => this.#by === by;
		const events: DriverEvents = {
			where: () => this.#place,
			move: (place) => mine() && this.#move(place),
			rest: () => mine() && this.#rest(),
			next: () => mine() && this.#next(),
			report: (words) => queueMicrotask(() => mine() && this.#set({ words })),
			fail: (words) => queueMicrotask(() => mine() && this.#set({ words, by: "pointer" })),
		};
		if (by === "camera") return new CameraDriver(this.#video, events);
		return by === "gamepad" ? new GamepadDriver(events) : new PointerDriver(this.#view.canvas, events);
	}

	/** Limits growth to one request per frame. */
	#move(to: Position): void {
		if (!this.#to) this.#frame = requestAnimationFrame(() => this.#follow());
		this.#to = to;
	}

	#follow(): void {
		const to = this.#to;
		this.#to = undefined;
		cancelAnimationFrame(this.#frame);
		if (!to) return;
		putAt(this.#hand, to);
		if (this.#awaited && Math.hypot(to.x - this.#place.x, to.y - this.#place.y) > NEAR) return;
		this.#awaited = false;
		this.#hand.hidden = true;
		this.#go(to);
	}

	#go({ x, y }: Position): void {
		const { across, up } = this.#pair;
		const values = new Map<string, number>();
		if (across) values.set(across.id, atShare(across, this.#mirrored(across, x)));
		if (up) values.set(up.id, atShare(up, 1 - y));
		this.#moved = true;
		this.#gestures.context.edit(this.#axes.to(values), GESTURE);
	}

	#rest(): void {
		this.#follow();
		if (!this.#moved) return;
		this.#moved = false;
		this.#gestures.context.settle(GESTURE);
		this.#announce();
	}

	#announce(): void {
		this.#status.textContent = this.#words.textContent;
	}

	/** Selects the next two numbers. They keep their values until the driver comes near the circle. */
	#next(): void {
		this.#rest();
		const { across, up } = this.#pair;
		this.#set(nextPair(this.#axes.all, { across: across?.id, up: up?.id }));
		this.#awaited = true;
		this.#hand.hidden = false;
	}

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
			const mirrored = axis === across && this.#mirrored(axis, 0) === 1;
			const change = this.#axes.to(new Map([[axis.id, axis.value + (mirrored ? -by : by)]]));
			this.#gestures.context.edit({ ...change, run: this.#runs.press(axis.id) }, GESTURE);
			this.#gestures.context.settle(GESTURE);
			this.#announce();
		} else return;
		event.preventDefault();
		event.stopPropagation();
	}

	#set(change: Partial<GestureState>): void {
		const { context, tool } = this.#gestures;
		context.setToolState(tool, { ...context.toolState(tool), ...change });
	}
}

function putAt({ style }: HTMLElement, { x, y }: Position): void {
	style.left = `${(100 * x).toFixed(2)}%`;
	style.top = `${(100 * y).toFixed(2)}%`;
}
