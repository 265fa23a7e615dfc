import type { OutlinePoint } from "./points";

/**
 * What the editor tells of. `outline-input`: live, once a frame at most. `outline-change`: a drag ended or was called off, a key
 * stepped, a point came or went. `outline-mirror`: the lock was pressed. `outline-refused`:
 * something would have made it cross itself, and was not done.
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
