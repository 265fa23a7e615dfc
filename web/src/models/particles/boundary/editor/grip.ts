/** What a flat view is given to be drawn and dragged, and what it tells. */
import type { Change } from "../../../../controls/desk";
import type { Point } from "./frame";

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

const ARROWS: Readonly<Record<string, readonly [right: number, up: number]>> = {
	ArrowLeft: [-1, 0],
	ArrowRight: [1, 0],
	ArrowUp: [0, 1],
	ArrowDown: [0, -1],
};

/** What a key on a grip does. */
export function changeBy(pose: Pose, id: string, { key, shiftKey }: Pick<KeyboardEvent, "key" | "shiftKey">) {
	const arrow = ARROWS[key];
	if (arrow) return pose.nudge(id, ...arrow, shiftKey);
	if (key === "Delete" || key === "Backspace") return pose.remove?.(id);
	return key === "Insert" || key === "+" ? pose.add?.(id) : undefined;
}

/** The grip within reach that is nearest to a point: reaches overlap where grips are close. */
export function nearestGrip(pose: Pose, point: Point, reach: number): Grip | undefined {
	let [nearest, least]: [Grip | undefined, number] = [undefined, reach];
	for (const grip of pose.grips) {
		const away = Math.hypot(grip.at.x - point.x, grip.at.y - point.y);
		if (away <= least) [nearest, least] = [grip, away];
	}
	return nearest;
}

declare global {
	interface HTMLElementEventMap {
		"grip-input": GripEvent;
		"grip-change": GripEvent;
		/** The grip that is meant from now on. */
		"grip-focus": CustomEvent<string>;
	}
}
