/** Devices that control two axes: a pointer, a gamepad, or the user's hand before the camera. */
import type { Position } from "./hand";

/** Events of a driver. Positions are shares of the picture, from the left and from the top. */
export interface DriverEvents {
	/** Returns the circle's current position, for drivers that move it relatively. */
	where(): Position;
	/** Moves the circle. */
	move(place: Position): void;
	/** The device rests: ends the undo step. */
	rest(): void;
	/** Selects the next pair of axes. */
	next(): void;
	/** Message to the user, a sentence. */
	report(message: string): void;
	/** The driver failed, with a message: the pointer replaces it. */
	fail(message: string): void;
}

export interface Driver {
	/** Stops the driver and its listeners. */
	stop(): void;
}
