/** What a flat view is given to be drawn and dragged, and what it tells. */
import type { Change } from "../../../../controls/desk";
import { ARROWS, type Point } from "../../../../controls/handles/point";

/** Something to take hold of. */
export interface Grip {
	readonly id: string;
	/** In the view's units. */
	readonly at: Point;
	/** What it is: "Point 3". */
	readonly label: string;
	/** Where it stands, in words: "2.1 m out, 3 m up". */
	readonly value: string;
}

/** What the grips stand for, and what moving them makes of it. */
export interface Pose {
	readonly grips: readonly Grip[];
	/** What they stand at, as a change that brings it back. */
	readonly change: Change;
	/** A grip moved to a point. */
	pull(id: string, to: Point): Change;
	/** One press of an arrow key; undefined where the grip cannot move so. */
	nudge(id: string, right: number, up: number, large: boolean): Change | undefined;
	/** What a double click, Delete and Insert on a grip do; undefined for nothing. */
	reset?(id: string): Change | undefined;
	remove?(id: string): Change | undefined;
	add?(id: string): Change | undefined;
}

/** `grip-input`: live, once a frame at most. `grip-change`: a drag ended, a key stepped, or Escape called it off. */
export type GripEvent = CustomEvent<Change>;

/** What a key on a grip does. */
export function changeBy(pose: Pose, id: string, { key, shiftKey }: Pick<KeyboardEvent, "key" | "shiftKey">) {
	const arrow = ARROWS[key];
	if (arrow) return pose.nudge(id, arrow.x, arrow.y, shiftKey);
	if (key === "Delete" || key === "Backspace") return pose.remove?.(id);
	return key === "Insert" || key === "+" ? pose.add?.(id) : undefined;
}

declare global {
	interface HTMLElementEventMap {
		"grip-input": GripEvent;
		"grip-change": GripEvent;
		/** The grip that is meant from now on. */
		"grip-focus": CustomEvent<string>;
	}
}
