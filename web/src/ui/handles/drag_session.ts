/**
 * Drags in progress in one view, one handle per pointer: connects pointer events with a model's pure functions. Live
 * events are limited to one per frame; the change is reported once, when the last pointer is released, so that one
 * drag, even with two fingers, is one undo step. Independent of DOM and three.js, and so shared by flat and
 * three-dimensional views.
 */
import type { Point } from "./point";

/** H: name of a handle. S: state that drags change. K: modifier keys held during a drag. */
export interface DragHost<H, S, K> {
	/** Returns the current state; other code may have changed it since the last call. */
	get(): S;
	/** Returns a handle's position, in the units of the session's positions. */
	place(handle: H): Point;
	/**
	 * Returns the state after dragging a handle to a position. `from` is the handle's position at the beginning of the
	 * drag.
	 */
	pull(state: S, handle: H, to: Point, held: { readonly from: Point; readonly keys?: K }): S;
	/** Returns whether two states are equal in all values that drags here change. */
	same(one: S, other: S): boolean;
	/** Returns the state after cancelling a drag; the default is the whole state before the drag. */
	restored?(now: S, before: S): S;
	/** Whether only one drag at a time is allowed. */
	readonly alone?: boolean;
	/** Reports a live state, at most once per frame; also the restored state when a drag is cancelled. */
	input(state: S): void;
	/** Ends a drag of which at least one state was reported. */
	change(): void;
	/** Schedules a callback before the next frame; the default is requestAnimationFrame. */
	schedule?(callback: () => void): void;
}

interface Held<H, K> {
	readonly handle: H;
	readonly from: Point;
	/** Offset from the pointer to the handle, so that the handle does not jump. */
	readonly offset: Point;
	/** Target position of the handle; undefined after it was applied. */
	target?: Point;
	keys?: K;
}

export class DragSession<H, S, K = undefined> {
	readonly #host: DragHost<H, S, K>;
	readonly #held = new Map<number, Held<H, K>>();
	#before: { readonly state: S } | undefined;
	/** Whether a state of the current drag was reported, so that `change` must follow. */
	#reported = false;
	#scheduled = false;

	constructor(host: DragHost<H, S, K>) {
		this.#host = host;
	}

	/** Whether any handle is dragged. */
	get active(): boolean {
		return this.#held.size > 0;
	}

	/** Returns whether a pointer drags this handle. */
	holds(handle: H): boolean {
		return [...this.#held.values()].some((held) => held.handle === handle);
	}

	/** Returns the handle that a pointer drags. */
	heldBy(pointer: number): H | undefined {
		return this.#held.get(pointer)?.handle;
	}

	/**
	 * Begins a drag.
	 * @param pointer id of the pointer
	 * @param at its position, in the host's units; the handle's offset from it remains during the drag
	 * @returns false if this pointer or this handle is already in use
	 */
	begin(pointer: number, handle: H, at: Point): boolean {
		const taken = this.#host.alone ? this.active : this.#held.has(pointer) || this.holds(handle);
		if (taken) return false;
		this.#before ??= { state: this.#host.get() };
		const from = this.#host.place(handle);
		this.#held.set(pointer, { handle, from, offset: { x: from.x - at.x, y: from.y - at.y } });
		return true;
	}

	/**
	 * Records the pointer's position; the change is applied in the next frame.
	 * @param at position in the view's units
	 */
	move(pointer: number, at: Point, keys?: K): void {
		const held = this.#held.get(pointer);
		if (!held) return;
		held.target = { x: at.x + held.offset.x, y: at.y + held.offset.y };
		held.keys = keys;
		if (this.#scheduled) return;
		this.#scheduled = true;
		const flush = () => {
			this.#scheduled = false;
			this.#flush();
		};
		if (this.#host.schedule) this.#host.schedule(flush);
		else requestAnimationFrame(flush);
	}

	/** Ends the drag of a pointer, after its last position was applied. */
	end(pointer: number): void {
		if (!this.#held.has(pointer)) return;
		this.#flush();
		this.#held.delete(pointer);
		if (!this.active) this.#endSession();
	}

	/** Releases all handles and restores the dragged values; other changes since the beginning stay. */
	cancel(): void {
		if (!this.#before) return;
		const { state } = this.#before;
		this.#held.clear();
		if (this.#reported) this.#host.input(this.#host.restored?.(this.#host.get(), state) ?? state);
		this.#endSession();
	}

	/** Releases all handles and retains the dragged values. */
	drop(): void {
		if (!this.#before) return;
		this.#held.clear();
		this.#endSession();
	}

	/** Ends the session after its last drag, and reports the change if there was one. */
	#endSession(): void {
		const reported = this.#reported;
		this.#before = undefined;
		this.#reported = false;
		if (reported) this.#host.change();
	}

	/** Applies the targets to the current state, not to the state when the pointer moved. */
	#flush(): void {
		const moved = [...this.#held.values()].filter(({ target }) => target);
		if (moved.length === 0) return;
		const before = this.#host.get();
		let state = before;
		for (const held of moved) {
			const { handle, target, from, keys } = held;
			held.target = undefined;
			state = this.#host.pull(state, handle, target as Point, { from, keys });
		}
		if (this.#host.same(before, state)) return;
		this.#reported = true;
		this.#host.input(state);
	}
}
