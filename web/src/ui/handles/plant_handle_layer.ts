/**
 * Layer of handles over the picture of a plant: buttons, moved by mouse, pen, finger or arrow keys. One of them is a
 * stop of the Tab key, and Page Up and Page Down move between them.
 */
import type { Change } from "../editor_context";
import { text } from "../messages.generated";
import { EscapeKey } from "./escape_key";
import { type PointerRay, placeUnder, visibleWays } from "./handle_ways";
import type { HandleVector, PlantHandle, PlantHandles } from "./plant_handle";
import { HANDLES_STYLE } from "./plant_handles_style";
import { ARROWS, nearest, type Point } from "./point";

/** View and document as the layer uses them. */
export interface HandleHost {
	readonly canvas: HTMLCanvasElement;
	/** Returns the position of a point in CSS pixels from the canvas's upper left corner. */
	project(at: HandleVector): Point;
	/** Returns the ray through a point of the canvas. */
	rayThrough(x: number, y: number): PointerRay;
	/** A drag begins; `cancel` must restore the state of this moment. */
	begin?(): void;
	/** Applies a change at once; the host then sets the handles again. */
	change(change: Change): void;
	/** The drag or key press ends. */
	settle(): void;
	/** A drag is cancelled. */
	cancel(): void;
	/** Called when a handle gets the focus. */
	focused?(id: string): void;
}

/** A drag in progress. */
interface Held {
	readonly id: string;
	readonly pointer: number;
	readonly ways: readonly HandleVector[];
	/** Offset from the pointer to the handle, so that the handle does not jump. */
	readonly offset: Point;
	/** Latest pointer event since the last frame. */
	to?: PointerEvent;
	moved: boolean;
}

const SVG = "http://www.w3.org/2000/svg";

export class PlantHandleLayer {
	readonly #host: HandleHost;
	readonly #layer = document.createElement("div");
	readonly #lines = document.createElementNS(SVG, "path");
	readonly #status = Object.assign(document.createElement("p"), { className: "unseen", role: "status" });
	readonly #buttons = new Map<string, HTMLButtonElement>();
	readonly #style = new CSSStyleSheet();
	readonly #root: Document | ShadowRoot;
	readonly #escape = new EscapeKey(() => this.cancel());
	#handles: readonly PlantHandle[] = [];
	#ends: readonly (readonly HandleVector[])[] = [];
	#held: Held | undefined;
	/** Last moved handle, and its last announced value; the handles after its change may be set later. */
	#announced: { readonly id: string; readonly value: string | undefined } | undefined;
	#frame = 0;

	/** Adds the layer after the host's canvas, and its style to the canvas's root. */
	constructor(host: HandleHost) {
		this.#host = host;
		this.#root = host.canvas.getRootNode() as Document | ShadowRoot;
		this.#style.replaceSync(HANDLES_STYLE);
		this.#root.adoptedStyleSheets.push(this.#style);
		this.#layer.className = "plant-handles";
		this.#layer.role = "group";
		this.#layer.ariaLabel = text("handles");
		this.#layer.part.add("handles");
		const svg = document.createElementNS(SVG, "svg");
		svg.setAttribute("aria-hidden", "true");
		svg.append(this.#lines);
		this.#layer.append(svg, this.#status);
		host.canvas.after(this.#layer);
	}

	/** Whether a handle is dragged. */
	get held(): boolean {
		return this.#held !== undefined;
	}

	/** Cancels a drag and removes the layer. */
	dispose(): void {
		this.cancel();
		cancelAnimationFrame(this.#frame);
		this.#layer.remove();
		this.#root.adoptedStyleSheets = this.#root.adoptedStyleSheets.filter((sheet) => sheet !== this.#style);
	}

	/** Replaces the handles; undefined removes all. */
	set(shown: PlantHandles | undefined): void {
		this.#handles = shown?.handles ?? [];
		this.#ends = shown?.lines ?? [];
		const ids = new Set(this.#handles.map(({ id }) => id));
		const before = [...this.#buttons.keys()];
		const focused = before.findIndex((id) => this.#buttons.get(id)?.matches(":focus"));
		for (const [id, button] of this.#buttons) {
			if (ids.has(id)) continue;
			button.remove();
			this.#buttons.delete(id);
		}
		for (const { id, label, value, kind } of this.#handles) {
			const button = this.#buttonOf(id);
			button.ariaLabel = text("handle_and_value", { label, value });
			if (kind) button.dataset.kind = kind;
			else delete button.dataset.kind;
		}
		const buttons = [...this.#buttons.values()];
		if (!buttons.some(({ tabIndex }) => tabIndex === 0) && buttons[0]) buttons[0].tabIndex = 0;
		if (focused >= 0 && !ids.has(before[focused])) this.#refocus(focused);
		this.#announce();
		this.place();
	}

	/** Moves the buttons to the handles' current positions. */
	place(): void {
		// All sizes are read before styles are written, because reading after each write would force a layout each
		// time.
		const { offsetLeft, offsetTop, clientWidth, clientHeight } = this.#host.canvas;
		const places = this.#handles.map(({ id, at }) => [id, this.#host.project(at)] as const);
		const projected = (point: HandleVector) => {
			const { x, y } = this.#host.project(point);
			return `${x.toFixed(1)} ${y.toFixed(1)}`;
		};
		const lines = this.#ends.map((line) => `M${line.map(projected).join("L")}`).join("");
		const { style } = this.#layer;
		style.translate = `${offsetLeft}px ${offsetTop}px`;
		style.width = `${clientWidth}px`;
		style.height = `${clientHeight}px`;
		for (const [id, { x, y }] of places)
			this.#buttonOf(id).style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
		this.#lines.setAttribute("d", lines);
	}

	/** Cancels the drag in progress. */
	cancel(): void {
		const held = this.#held;
		if (!held) return;
		this.#end();
		if (held.moved) this.#host.cancel();
	}

	/** Returns the button of a handle; creates it with its listeners on first use. */
	#buttonOf(id: string): HTMLButtonElement {
		const before = this.#buttons.get(id);
		if (before) return before;
		const button = Object.assign(document.createElement("button"), { type: "button", tabIndex: -1 });
		button.ariaRoleDescription = "handle";
		button.part.add("handle");
		button.addEventListener("pointerdown", (event) => this.#grasp(event));
		button.addEventListener("pointermove", (event) => this.#move(event));
		for (const type of ["pointerup", "lostpointercapture"] as const)
			button.addEventListener(type, (event) => this.#release(event));
		button.addEventListener("keydown", (event) => this.#press(id, event));
		button.addEventListener("focus", () => {
			this.#stopAt(button);
			this.#host.focused?.(id);
		});
		this.#buttons.set(id, button);
		this.#layer.append(button);
		return button;
	}

	/** Begins a drag; if buttons overlap, of the handle nearest to the pointer. */
	#grasp(event: PointerEvent): void {
		const at = this.#pointOf(event);
		const places = this.#handles.map((each) => [each, this.#host.project(each.at)] as const);
		const handle = nearest(places, at, Number.POSITIVE_INFINITY);
		if (event.button !== 0 || this.#held || !handle) return;
		const { id } = handle;
		const seen = this.#host.project(handle.at);
		this.#host.begin?.();
		this.#held = {
			id,
			pointer: event.pointerId,
			ways: visibleWays(handle.along, this.#host.rayThrough(seen.x, seen.y)),
			offset: { x: seen.x - at.x, y: seen.y - at.y },
			moved: false,
		};
		const button = this.#buttons.get(id);
		// The dragged handle gets the focus, even if another button is on top.
		event.preventDefault();
		button?.focus();
		button?.setPointerCapture(event.pointerId);
		this.#escape.listen(true);
	}

	/** Records the pointer's position, which the next frame applies: growth is limited to one request per frame. */
	#move(event: PointerEvent): void {
		const held = this.#held;
		if (held?.pointer !== event.pointerId) return;
		if (!held.to) this.#frame = requestAnimationFrame(() => this.#pull());
		held.to = event;
	}

	/** Moves the held handle to the pointer's last position, at most once per frame. */
	#pull(): void {
		const held = this.#held;
		const handle = this.#handles.find(({ id }) => id === held?.id);
		if (!held?.to || !handle) return;
		const { x, y } = this.#pointOf(held.to);
		held.to = undefined;
		const place = placeUnder(handle.at, held.ways, this.#host.rayThrough(x + held.offset.x, y + held.offset.y));
		if (!place) return;
		held.moved = true;
		this.#host.change(handle.pull(place));
	}

	/** Ends a drag, with the last position applied. */
	#release(event: PointerEvent): void {
		const held = this.#held;
		if (held?.pointer !== event.pointerId) return;
		this.#pull();
		this.#end();
		if (held.moved) this.#settle(held.id, undefined);
	}

	/** Forgets the drag in progress. */
	#end(): void {
		this.#held = undefined;
		this.#escape.listen(false);
	}

	/** Handles a key on a handle: arrows move it, Delete removes it, Page Up and Page Down go to another. */
	#press(id: string, event: KeyboardEvent): void {
		const { key, shiftKey, ctrlKey, metaKey, altKey } = event;
		const handle = this.#handles.find((each) => each.id === id);
		if (!handle || ctrlKey || metaKey || altKey) return;
		const arrow = ARROWS[key];
		if (arrow) {
			this.#host.change(handle.nudge(arrow.x, arrow.y, shiftKey));
			this.#settle(id, handle.value);
		} else if (key === "Delete" && handle.remove) {
			this.#host.change(handle.remove());
			this.#host.settle();
		} else if (key === "PageDown" || key === "PageUp") this.#focusOther(id, key === "PageDown" ? 1 : -1);
		else return;
		event.preventDefault();
	}

	/**
	 * Focuses another handle, cyclically.
	 * @param step 1 for the next handle, −1 for the one before
	 */
	#focusOther(id: string, step: number): void {
		const ids = this.#handles.map((each) => each.id);
		const next = ids.at((ids.indexOf(id) + step) % ids.length);
		if (next !== undefined) this.#buttonOf(next).focus();
	}

	/** Makes a button the only stop of the Tab key. */
	#stopAt(stop: HTMLButtonElement): void {
		for (const button of this.#buttons.values()) button.tabIndex = button === stop ? 0 : -1;
	}

	/**
	 * Moves the focus after a handle was removed: to the handle at the same index, else to the canvas.
	 * @param place index of the removed handle
	 */
	#refocus(place: number): void {
		const next = this.#handles[Math.min(place, this.#handles.length - 1)];
		const to = next ? this.#buttonOf(next.id) : this.#host.canvas;
		to.focus();
	}

	/**
	 * Ends a change, and announces the handle's new value.
	 * @param before value that was announced last
	 */
	#settle(id: string, before: string | undefined): void {
		this.#host.settle();
		this.#announced = { id, value: before };
		this.#announce();
	}

	/** Announces the value of a handle after it was moved. */
	#announce(): void {
		const announced = this.#announced;
		const value = this.#handles.find(({ id }) => id === announced?.id)?.value;
		if (!announced || this.#held || value === undefined || value === announced.value) return;
		this.#status.textContent = value;
		this.#announced = { id: announced.id, value };
	}

	/** Returns a pointer's position in CSS pixels from the canvas's upper left corner. */
	#pointOf({ clientX, clientY }: PointerEvent): Point {
		const { left, top } = this.#layer.getBoundingClientRect();
		return { x: clientX - left, y: clientY - top };
	}
}
