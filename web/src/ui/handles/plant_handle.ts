/** Types of handles on the plant itself, in three dimensions. */
import type { Change } from "../editor_context";

export type Vector = readonly [x: number, y: number, z: number];

/** A draggable handle. Its methods return changes of the specimen that it was made from. */
export interface PlantHandle {
	readonly id: string;
	/** Name of the handle: "Length". */
	readonly label: string;
	/** Where it stands, in words: "14.2 mm". */
	readonly value: string;
	/** How it looks, where not as most do. */
	readonly kind?: "size" | "turn" | "chosen";
	/** In the plant's metres. */
	readonly at: Vector;
	/** One or two directions, of length 1, in which it can go; or three at right angles, of which the two seen best are taken. */
	readonly along: readonly Vector[];
	/** Taken to a place by a pointer. */
	pull(to: Vector): Change;
	/** By the Delete key, where it can go. */
	remove?(): Change;
	/** One press of an arrow key: 1, 0 or −1 to the right and up. */
	nudge(right: number, up: number, large: boolean): Change;
}

/** All that is shown of them. */
export interface PlantHandles {
	readonly handles: readonly PlantHandle[];
	/** Polylines that show the handles' shape. */
	readonly lines: readonly (readonly Vector[])[];
}

/** The handles of a specimen; `preset` is its preset as published. */
export type HandlesOf<S> = (specimen: S, preset: S) => PlantHandles;
