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

export interface PickHost {
	/** Class of the canvas while picking is enabled. */
	readonly name: string;
	/** Returns the id at a point of the canvas, in CSS pixels from its top left corner. */
	at(x: number, y: number): number | undefined;
	/** False if parts under the pointer are not marked. */
	readonly hovers?: false;
	mark(id: number | undefined): void;
	take(id: number): void;
}

/** Largest movement of a click, in CSS pixels; larger for touch. */
const MOUSE_TREMBLE = 4;
const TOUCH_TREMBLE = 10;

interface Press {
	readonly pointer: number;
	readonly x: number;
	readonly y: number;
}

export class PickPointer {
	readonly #view: PickView;
	readonly #host: PickHost;
	#enabled = false;
	#press: Press | undefined;
	/** Pressed pointers; two of them zoom. */
	readonly #down = new Set<number>();

	constructor(view: PickView, host: PickHost) {
		this.#view = view;
		this.#host = host;
		const { canvas } = view;
		canvas.addEventListener("pointerdown", this.#onDown);
		canvas.addEventListener("pointermove", this.#onMove);
		canvas.addEventListener("pointerup", this.#onUp);
		canvas.addEventListener("pointercancel", this.#onCancel);
		canvas.addEventListener("pointerleave", this.#onLeave);
	}

	dispose(): void {
		this.enabled = false;
		const { canvas } = this.#view;
		canvas.removeEventListener("pointerdown", this.#onDown);
		canvas.removeEventListener("pointermove", this.#onMove);
		canvas.removeEventListener("pointerup", this.#onUp);
		canvas.removeEventListener("pointercancel", this.#onCancel);
		canvas.removeEventListener("pointerleave", this.#onLeave);
	}

	set enabled(on: boolean) {
		if (on === this.#enabled) return;
		this.#enabled = on;
		this.#press = undefined;
		this.#view.canvas.classList.toggle(this.#host.name, on);
		if (!on) this.#host.mark(undefined);
	}

	readonly #onDown = (event: PointerEvent): void => {
		this.#down.add(event.pointerId);
		const alone = this.#down.size === 1 && event.button === 0 && this.#view.orbiting;
		this.#press = alone && this.#enabled ? { pointer: event.pointerId, x: event.clientX, y: event.clientY } : undefined;
	};

	readonly #onMove = (event: PointerEvent): void => {
		if (!this.#enabled) return;
		if (this.#press && !near(this.#press, event)) this.#press = undefined;
		if (this.#host.hovers === false) return;
		if (event.buttons === 0 && event.pointerType !== "touch" && this.#view.orbiting) this.#host.mark(this.#at(event));
	};

	readonly #onUp = (event: PointerEvent): void => {
		this.#down.delete(event.pointerId);
		const press = this.#press;
		this.#press = undefined;
		if (!press || press.pointer !== event.pointerId || !near(press, event)) return;
		const id = this.#at(event);
		if (id !== undefined) this.#host.take(id);
	};

	readonly #onCancel = (event: PointerEvent): void => {
		this.#down.delete(event.pointerId);
		this.#press = undefined;
	};

	readonly #onLeave = (event: PointerEvent): void => {
		this.#onCancel(event);
		if (this.#enabled) this.#host.mark(undefined);
	};

	#at({ clientX, clientY }: PointerEvent): number | undefined {
		const { left, top } = this.#view.canvas.getBoundingClientRect();
		return this.#host.at(clientX - left, clientY - top);
	}
}

function near({ x, y }: Press, { clientX, clientY, pointerType }: PointerEvent): boolean {
	const tremble = pointerType === "touch" ? TOUCH_TREMBLE : MOUSE_TREMBLE;
	return Math.hypot(clientX - x, clientY - y) <= tremble;
}
