/**
 * The drags going on in one view, one handle to a pointer: what comes between pointer events and a model's pure maths.
 * Live events are held to one a frame; the change is told once, when the last pointer lets go, so that one drag (even of
 * two fingers) is one undo step. It knows neither DOM nor three.js: flat views and handles in three dimensions share it.
 */
import type { Point } from "./point";

/** H names a handle, S is what drags change, K what is known of the keys held meanwhile. */
export interface DragHost<H, S, K> {
	/** What a drag changes, as it is now; others may have changed it since the last call. */
	get(): S;
	/** Where a handle stands, in the units of the places that the session is given. */
	place(handle: H): Point;
	/** What comes of a handle taken to a place; `from` is where it stood when it was taken hold of. */
	pull(state: S, handle: H, to: Point, held: { readonly from: Point; readonly keys?: K }): S;
	/** Whether two are the same in all that a drag here changes. */
	same(one: S, other: S): boolean;
	/** What a drag called off leaves of `now`; the default is all as it was before. */
	restored?(now: S, before: S): S;
	/** Whether a second finger has to wait. */
	readonly alone?: boolean;
	/** Live, at most once a frame; also with what was before, when a drag is called off. */
	input(state: S): void;
	/** A drag of which anything was told is over. */
	change(): void;
	/** Calls back before the next frame; the default is the page's. */
	schedule?(callback: () => void): void;
}

interface Held<H, K> {
	readonly handle: H;
	readonly from: Point;
	/** From the pointer to the handle, so that it does not jump. */
	readonly offset: Point;
	/** Where the handle is to go; undefined once it has gone there. */
	target?: Point;
	keys?: K;
}

export class DragSession<H, S, K = undefined> {
	readonly #host: DragHost<H, S, K>;
	readonly #held = new Map<number, Held<H, K>>();
	#before: { readonly state: S } | undefined;
	/** Whether the host was told anything of this drag, and so must be told of its end. */
	#reported = false;
	#scheduled = false;

	constructor(host: DragHost<H, S, K>) {
		this.#host = host;
	}

	get active(): boolean {
		return this.#held.size > 0;
	}

	holds(handle: H): boolean {
		return [...this.#held.values()].some((held) => held.handle === handle);
	}

	/** The handle in that pointer's hand. */
	heldBy(pointer: number): H | undefined {
		return this.#held.get(pointer)?.handle;
	}

	/** Takes hold of a handle; false where this pointer or this handle is taken already. */
	begin(pointer: number, handle: H, at: Point): boolean {
		const taken = this.#host.alone ? this.active : this.#held.has(pointer) || this.holds(handle);
		if (taken) return false;
		this.#before ??= { state: this.#host.get() };
		const from = this.#host.place(handle);
		this.#held.set(pointer, { handle, from, offset: { x: from.x - at.x, y: from.y - at.y } });
		return true;
	}

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

	end(pointer: number): void {
		if (!this.#held.has(pointer)) return;
		this.#flush();
		this.#held.delete(pointer);
		if (!this.active) this.#over();
	}

	/** Lets go of every handle and puts back what drags here change; what others changed meanwhile stays. */
	cancel(): void {
		if (!this.#before) return;
		const { state } = this.#before;
		this.#held.clear();
		if (this.#reported) this.#host.input(this.#host.restored?.(this.#host.get(), state) ?? state);
		this.#over();
	}

	/** Lets go of every handle; what they have changed stays. */
	drop(): void {
		if (!this.#before) return;
		this.#held.clear();
		this.#over();
	}

	#over(): void {
		const reported = this.#reported;
		this.#before = undefined;
		this.#reported = false;
		if (reported) this.#host.change();
	}

	/** Applies the targets to the state as it is now, not as it was when the pointer moved. */
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
