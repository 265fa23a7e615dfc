import type { OutlinePoint } from "./points";

/**
 * What the editor tells of. `outline-input`: live, once a frame at most. `outline-change`: a drag ended, a key stepped, a point came or
 * went. `outline-cancel`: Escape. `outline-mirror`: the lock was pressed.
 */
export type OutlineEvent = CustomEvent<{ outline: OutlinePoint[] }>;

declare global {
	interface HTMLElementEventMap {
		"outline-input": OutlineEvent;
		"outline-change": OutlineEvent;
		"outline-cancel": OutlineEvent;
		"outline-mirror": CustomEvent;
	}
}
