/**
 * Picks parts of the plant in the 3-D view: the pointer marks the part under it, and a click takes the part. A pointer
 * that moves while it is pressed turns the plant and takes nothing.
 */

/** Used part of the view. */
export interface PickView {
	readonly canvas: HTMLElement;
	/** Whether pointers turn the plant; false while a handle is dragged. */
	readonly orbiting: boolean;
}

/** @typeParam T a picked part: by default its id */
export interface PickHost<T = number> {
	/** Class of the canvas while picking is enabled. */
	readonly name: string;
	/** Returns the part at a point of the canvas, in CSS pixels from its top left corner. */
	at(x: number, y: number): T | undefined;
	/** False if parts under the pointer are not marked. */
	readonly hovers?: false;
	mark(part: T | undefined): void;
	take(part: T): void;
}

/** Largest movement of a click, in CSS pixels; larger for touch. */
const MOUSE_TREMBLE = 4;
const TOUCH_TREMBLE = 10;

interface Press {
	readonly pointer: number;
	readonly x: number;
	readonly y: number;
}

export class PickPointer<T = number> {
	readonly #view: PickView;
	readonly #host: PickHost<T>;
	#enabled = false;
	#press: Press | undefined;
	/** Pressed pointers; two of them zoom. */
	readonly #down = new Set<number>();

	/** @param host finds and marks parts, and takes the clicked one */
	constructor(view: PickView, host: PickHost<T>) {
		this.#view = view;
		this.#host = host;
		const { canvas } = view;
		canvas.addEventListener("pointerdown", this.#onDown);
		canvas.addEventListener("pointermove", this.#onMove);
		canvas.addEventListener("pointerup", this.#onUp);
		canvas.addEventListener("pointercancel", this.#onCancel);
		canvas.addEventListener("pointerleave", this.#onLeave);
	}

	/** Removes the mark and all listeners. */
	dispose(): void {
		this.enabled = false;
		const { canvas } = this.#view;
		canvas.removeEventListener("pointerdown", this.#onDown);
		canvas.removeEventListener("pointermove", this.#onMove);
		canvas.removeEventListener("pointerup", this.#onUp);
		canvas.removeEventListener("pointercancel", this.#onCancel);
		canvas.removeEventListener("pointerleave", this.#onLeave);
	}

	/** Sets whether parts are marked and taken. */
	set enabled(on: boolean) {
		if (on === this.#enabled) return;
		this.#enabled = on;
		this.#press = undefined;
		this.#view.canvas.classList.toggle(this.#host.name, on);
		if (!on) this.#host.mark(undefined);
	}

	/** Begins a press, which becomes a click if the pointer stays where it is. */
	readonly #onDown = (event: PointerEvent): void => {
		this.#down.add(event.pointerId);
		const alone = this.#down.size === 1 && event.button === 0 && this.#view.orbiting;
		this.#press = alone && this.#enabled ? { pointer: event.pointerId, x: event.clientX, y: event.clientY } : undefined;
	};

	/** Marks the part under a pointer that is not pressed, and ends a press that has become a drag. */
	readonly #onMove = (event: PointerEvent): void => {
		if (!this.#enabled) return;
		if (this.#press && !near(this.#press, event)) this.#press = undefined;
		if (this.#host.hovers === false) return;
		if (event.buttons === 0 && event.pointerType !== "touch" && this.#view.orbiting)
			this.#host.mark(this.#partAt(event));
	};

	/** Takes the part under a click. */
	readonly #onUp = (event: PointerEvent): void => {
		this.#down.delete(event.pointerId);
		const press = this.#press;
		this.#press = undefined;
		if (!press || press.pointer !== event.pointerId || !near(press, event)) return;
		const part = this.#partAt(event);
		if (part !== undefined) this.#host.take(part);
	};

	/** Forgets a pointer that the browser has cancelled. */
	readonly #onCancel = (event: PointerEvent): void => {
		this.#down.delete(event.pointerId);
		this.#press = undefined;
	};

	/** Forgets the pointer and removes the mark. */
	readonly #onLeave = (event: PointerEvent): void => {
		this.#onCancel(event);
		if (this.#enabled) this.#host.mark(undefined);
	};

	/** Returns the part under a pointer; undefined if there is none. */
	#partAt({ clientX, clientY }: PointerEvent): T | undefined {
		const { left, top } = this.#view.canvas.getBoundingClientRect();
		return this.#host.at(clientX - left, clientY - top);
	}
}

/** Returns whether a pointer is near enough to its press to count as a click. */
function near({ x, y }: Press, { clientX, clientY, pointerType }: PointerEvent): boolean {
	const tremble = pointerType === "touch" ? TOUCH_TREMBLE : MOUSE_TREMBLE;
	return Math.hypot(clientX - x, clientY - y) <= tremble;
}
