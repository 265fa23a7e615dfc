import type { OutlinePoint } from "./points";

/**
 * Events of the editor. `outline-input`: during a drag, at most once a frame. `outline-change`: a drag ended or was
 * cancelled, a key moved a point, or a point was added or removed. `outline-mirror`: the lock was pressed.
 * `outline-refused`: a change was rejected because the outline would have crossed itself.
 */
export type OutlineEvent = CustomEvent<{ outline: OutlinePoint[]; run?: string }>;

declare global {
	interface HTMLElementEventMap {
		"outline-input": OutlineEvent;
		"outline-change": CustomEvent;
		"outline-mirror": CustomEvent;
		"outline-refused": CustomEvent;
	}
}
