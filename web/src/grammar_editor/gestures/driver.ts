/** What drives two axes: a pointer, a gamepad, a hand before the camera. Each says where it is, and when the next pair is wanted. */
import type { Position } from "./hand";

/** What a driver tells. Places are shares of the way from the left and from the top. */
export interface DriverEvents {
	/** Where the circle stands now, for drivers that move it on. */
	where(): Position;
	/** It is somewhere else. */
	move(place: Position): void;
	/** It has come to rest: what it did is one step. */
	rest(): void;
	/** The next pair of axes. */
	next(): void;
	/** What is to be known of it, in a sentence. */
	report(words: string): void;
	/** It cannot go on, and why: the pointer takes its place. */
	fail(words: string): void;
}

export interface Driver {
	/** Ends it: nothing of it runs or listens on. */
	stop(): void;
}
