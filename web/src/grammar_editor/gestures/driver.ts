/** Devices that control two axes: a pointer, a gamepad, or the user's hand before the camera. */
import type { Position } from "./hand";

/** Events of a driver. Positions are shares of the picture, from the left and from the top. */
export interface DriverEvents {
	/** Where the circle stands now, for drivers that move it on. */
	where(): Position;
	/** It is somewhere else. */
	move(place: Position): void;
	/** The device rests: ends the undo step. */
	rest(): void;
	/** The next pair of axes. */
	next(): void;
	/** Message to the user, a sentence. */
	report(words: string): void;
	/** It cannot go on, and why: the pointer takes its place. */
	fail(words: string): void;
}

export interface Driver {
	/** Ends it: nothing of it runs or listens on. */
	stop(): void;
}
