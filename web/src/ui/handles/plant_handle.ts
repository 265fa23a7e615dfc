/** Types of handles on the plant itself, in three dimensions. */
import type { Change } from "../editor_context";

export type HandleVector = readonly [x: number, y: number, z: number];

/** A draggable handle. Its methods return changes of the specimen that it was made from. */
export interface PlantHandle {
	readonly id: string;
	/** Name of the handle: "Length". */
	readonly label: string;
	/** Value of the handle as text: "14.2 mm". */
	readonly value: string;
	/** Appearance, if not the usual one. */
	readonly kind?: "size" | "turn" | "chosen";
	/** Position in the plant's metres. */
	readonly at: HandleVector;
	/**
	 * One or two directions of movement, of length 1; or three perpendicular ones, of which the two most visible are
	 * used.
	 */
	readonly along: readonly HandleVector[];
	/** Returns the change after dragging the handle to a position. */
	pull(to: HandleVector): Change;
	/** Returns the change of the Delete key, if the handle can be removed. */
	remove?(): Change;
	/** Returns the change of an arrow key: 1, 0 or −1 to the right and up. */
	nudge(right: number, up: number, large: boolean): Change;
}

/** Handles and lines of a specimen. */
export interface PlantHandles {
	readonly handles: readonly PlantHandle[];
	/** Polylines that show the handles' shape. */
	readonly lines: readonly (readonly HandleVector[])[];
}

/** Returns the handles of a specimen; `preset` is its published preset. */
export type HandlesOf<S> = (specimen: S, preset: S) => PlantHandles;
