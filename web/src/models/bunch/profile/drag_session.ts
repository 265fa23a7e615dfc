/**
 * The drags going on in one view, one handle to a pointer: what comes between pointer events and the pure maths of
 * drag.ts. Live events are held to one a frame; the change is told once, when the last pointer lets go, so that one
 * drag (even of two fingers) is one undo step. It knows neither DOM nor three.js; the 2-D views and the 3-D handles
 * share it.
 */
import { type DragOptions, dragHandle, type Grab, grabHandle, pullHandle, sameShape } from "./drag";
import { type Handle, handleKeys, type Point, type Shape } from "./handles";

export interface DragHost<P extends Shape> {
	/** Handles whose numbers a drag here may change. */
	handles(): readonly Handle[];
	/** The parameters as they are now; others may have changed them since the last call. */
	get(): P;
	/** Live, at most once a frame. */
	input(parameters: P): void;
	/** The drag ended and something is different. */
	change(parameters: P): void;
	/** The drag was called off, or led back to where it began; `parameters` are those from before it. */
	cancel(parameters: P): void;
	/** Calls back before the next frame (requestAnimationFrame in a page). */
	schedule(callback: () => void): void;
}

interface Held {
	grab: Grab;
	/** Where the handle is to go; undefined once it has gone there. */
	target?: Point;
	options?: DragOptions;
}

export class DragSession<P extends Shape> {
	readonly #host: DragHost<P>;
	readonly #held = new Map<number, Held>();
	#before: P | undefined;
	/** Whether the host was told anything of this drag, and so must be told of its end. */
	#told = false;
	#scheduled = false;

	constructor(host: DragHost<P>) {
		this.#host = host;
	}

	get active(): boolean {
		return this.#held.size > 0;
	}

	holds(handle: Handle): boolean {
		return [...this.#held.values()].some(({ grab }) => grab.handle === handle);
	}

	/** The handle in that pointer's hand. */
	heldBy(pointer: number): Handle | undefined {
		return this.#held.get(pointer)?.grab.handle;
	}

	/** Takes hold of a handle; false where this pointer or this handle is taken already. */
	begin(pointer: number, handle: Handle, at: Point): boolean {
		if (this.#held.has(pointer) || this.holds(handle)) return false;
		const parameters = this.#host.get();
		this.#before ??= parameters;
		this.#held.set(pointer, { grab: grabHandle(parameters, handle, at) });
		return true;
	}

	move(pointer: number, at: Point, straight = false, options?: DragOptions): void {
		const held = this.#held.get(pointer);
		if (!held) return;
		held.target = pullHandle(held.grab, at, straight);
		held.options = options;
		if (this.#scheduled) return;
		this.#scheduled = true;
		this.#host.schedule(() => {
			this.#scheduled = false;
			this.#flush();
		});
	}

	end(pointer: number): void {
		if (!this.#held.has(pointer)) return;
		this.#flush();
		this.#held.delete(pointer);
		if (this.active) return;
		const before = this.#before as P;
		this.#before = undefined;
		const now = this.#host.get();
		if (!sameShape(before, now, this.#host.handles())) this.#host.change(now);
		else if (this.#told) this.#host.cancel(now);
		this.#told = false;
	}

	/** Lets go of every handle and puts back what this view's handles set; what others changed meanwhile stays. */
	cancel(): void {
		if (!this.active) return;
		const before = this.#before as P;
		this.#before = undefined;
		this.#told = false;
		this.#held.clear();
		const restored = { ...this.#host.get() };
		for (const key of this.#host.handles().flatMap(handleKeys)) restored[key] = before[key];
		this.#host.cancel(restored);
	}

	/** Applies the targets to the parameters as they are now, not as they were when the pointer moved. */
	#flush(): void {
		const before = this.#host.get();
		let parameters = before;
		for (const held of this.#held.values()) {
			if (!held.target) continue;
			parameters = dragHandle(parameters, held.grab.handle, held.target, held.options);
			held.target = undefined;
		}
		if (sameShape(before, parameters, this.#host.handles())) return;
		this.#told = true;
		this.#host.input(parameters);
	}
}
