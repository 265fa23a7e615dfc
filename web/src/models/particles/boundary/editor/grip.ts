/** What a flat view is given to be drawn and dragged, and what it tells. */
import type { Change } from "../../../../ui/editor_context";
import { ARROWS, type Point } from "../../../../ui/handles/point";

/** Something to take hold of, and what hands do to it: changes of the specimen that the pose was made of. */
export interface Grip {
	readonly id: string;
	/** In the view's units. */
	readonly at: Point;
	/** What it is: "Point 3". */
	readonly label: string;
	/** What of that, where there are several grips to one: "size". */
	readonly part?: string;
	/** Where it stands, in words: "2.1 m out, 3 m up". */
	readonly value: string;
	/** Taken to a place by a pointer. */
	pull(to: Point): Change;
	/** One press of an arrow key. */
	nudge(right: number, up: number, large: boolean): Change;
	/** What a double click does: the preset's own numbers are back. */
	reset?(): Change | undefined;
	/** What Delete and Insert do; absent where they do nothing. */
	remove?(): Change;
	add?(): Change;
}

export interface Pose {
	readonly grips: readonly Grip[];
	/** All that grips can change, as it is. */
	readonly change: Change;
}

/** `grip-input`: live, once a frame at most. `grip-change`: a drag ended, a key stepped, or Escape called it off. */
export type GripEvent = CustomEvent<Change>;

export const gripIn = (pose: Pose | undefined, id: string): Grip | undefined =>
	pose?.grips.find((grip) => grip.id === id);

/** What a key on a grip does, and what is said of it besides where the grip stands then. */
export function pressed(
	grip: Grip,
	{ key, shiftKey }: Pick<KeyboardEvent, "key" | "shiftKey">,
): { change: Change; message?: string } | undefined {
	const arrow = ARROWS[key];
	if (arrow) return { change: grip.nudge(arrow.x, arrow.y, shiftKey) };
	const { label } = grip;
	if (key === "Delete" || key === "Backspace")
		return grip.remove && { change: grip.remove(), message: `${label} taken out` };
	if (key === "Insert" || key === "+") return grip.add && { change: grip.add(), message: "Point added" };
	return undefined;
}

declare global {
	interface HTMLElementEventMap {
		"grip-input": GripEvent;
		"grip-change": GripEvent;
		/** The grip that is meant from now on. */
		"grip-focus": CustomEvent<string>;
	}
}
