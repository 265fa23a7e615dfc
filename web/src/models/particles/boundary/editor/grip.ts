/** Grips that a flat view draws and drags, and the events that it dispatches. */

import type { Change } from "../../../../ui/editor_context";
import { ARROWS, type Point } from "../../../../ui/handles/point";
import { text } from "../../messages.generated";

/** A draggable point, and the changes of the specimen that dragging and keys cause. */
export interface Grip {
	readonly id: string;
	/** Position in the view's units. */
	readonly at: Point;
	/** Name of the element that the grip moves: "Point 3". */
	readonly label: string;
	/** Part of the element, where several grips belong to one: "size". */
	readonly part?: string;
	/** Position as text: "2.1 m out, 3 m up". */
	readonly value: string;
	/** The change after a drag to a position. */
	pull(to: Point): Change;
	/** The change after one press of an arrow key. */
	nudge(right: number, up: number, large: boolean): Change;
	/** The change after a double click: the preset's values. */
	reset?(): Change | undefined;
	/** The changes after Delete and Insert; absent where the keys do nothing. */
	remove?(): Change;
	add?(): Change;
}

export interface Pose {
	readonly grips: readonly Grip[];
	/** The present values of all fields that grips can change. */
	readonly change: Change;
}

/**
 * `grip-input`: during a drag, at most once a frame. `grip-change`: a drag ended or was cancelled, or a key changed a
 * value.
 */
export type GripEvent = CustomEvent<Change>;

/** Returns the grip of an id; undefined where there is none. */
export const gripIn = (pose: Pose | undefined, id: string): Grip | undefined =>
	pose?.grips.find((grip) => grip.id === id);

/**
 * Returns the change that a key causes on a grip, with a message for screen readers where the new position does not
 * suffice.
 */
export function pressed(
	grip: Grip,
	{ key, shiftKey }: Pick<KeyboardEvent, "key" | "shiftKey">,
): { change: Change; message?: string } | undefined {
	const arrow = ARROWS[key];
	if (arrow) return { change: grip.nudge(arrow.x, arrow.y, shiftKey) };
	const { label } = grip;
	if (key === "Delete" || key === "Backspace")
		return grip.remove && { change: grip.remove(), message: text("deleted", { name: label }) };
	if (key === "Insert" || key === "+") return grip.add && { change: grip.add(), message: text("point_added") };
	return undefined;
}

declare global {
	interface HTMLElementEventMap {
		"grip-input": GripEvent;
		"grip-change": GripEvent;
		/** The id of the grip that has the focus from now on. */
		"grip-focus": CustomEvent<string>;
	}
}
