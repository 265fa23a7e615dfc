/**
 * The drags of an outline's points, one to a pointer: live at most once a frame, one change when the last pointer lets go.
 * A point stops where the outline would cross itself. It knows no DOM.
 */
import { movePoint, type OutlinePoint, type OutlinePoints, type Place, type Symmetry } from "./points";
import { enclosesBlade } from "./spline";

export interface OutlineDragHost {
	get(): OutlinePoints;
	symmetry(): Symmetry;
	/** Live. */
	input(points: OutlinePoint[]): void;
	/** The last pointer has let go. */
	change(): void;
	/** Back to what was before. */
	cancel(points: OutlinePoint[]): void;
	/** Calls back before the next frame. */
	schedule(callback: () => void): void;
}

interface Held {
	index: number;
	/** From the pointer to the point. */
	away: Place;
	target?: Place | undefined;
}

export class OutlineDrag {
	readonly #host: OutlineDragHost;
	readonly #held = new Map<number, Held>();
	#before: OutlinePoints | undefined;
	#scheduled = false;

	constructor(host: OutlineDragHost) {
		this.#host = host;
	}

	get active(): boolean {
		return this.#held.size > 0;
	}

	holds(index: number): boolean {
		return [...this.#held.values()].some((held) => held.index === index);
	}

	/** Takes hold of a point; false where this pointer or this point is taken already. */
	begin(pointer: number, index: number, at: Place): boolean {
		if (this.#held.has(pointer) || this.holds(index)) return false;
		const points = this.#host.get();
		this.#before ??= points;
		const { x, y } = points[index];
		this.#held.set(pointer, { index, away: { x: x - at.x, y: y - at.y } });
		return true;
	}

	move(pointer: number, at: Place): void {
		const held = this.#held.get(pointer);
		if (!held) return;
		held.target = { x: at.x + held.away.x, y: at.y + held.away.y };
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
		this.#before = undefined;
		this.#host.change();
	}

	/** Lets go of every point and puts all back. */
	cancel(): void {
		const before = this.#before;
		this.#held.clear();
		this.#before = undefined;
		if (before) this.#host.cancel([...before]);
	}

	#flush(): void {
		for (const held of this.#held.values()) {
			const { index, target } = held;
			held.target = undefined;
			const points = this.#host.get();
			if (!target || index >= points.length) continue;
			const moved = movePoint(points, index, target, this.#host.symmetry());
			if (enclosesBlade(moved)) this.#host.input(moved);
		}
	}
}
