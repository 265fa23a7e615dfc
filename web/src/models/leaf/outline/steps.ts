/** Edits of the chosen point by keys and buttons, each with a message for screen readers. Pure functions. */

import { ARROWS } from "../../../ui/handles/point";
import { text } from "../messages.generated";
import { kindInWords, placeInWords } from "./outline_words";
import {
	insertedAt,
	insertPoint,
	movePoint,
	type OutlinePoint,
	type OutlinePoints,
	type Place,
	removePoint,
	type Symmetry,
	turnKind,
} from "./points";
import { enclosesBlade, placeOn, spansOf } from "./spline";

export interface Step {
	/** The outline after the edit; absent where it is unchanged. */
	points?: OutlinePoint[];
	/** Index of the chosen point after the edit; absent where it is unchanged. */
	chosen?: number;
	message: string;
}

/** Step of an arrow key, in leaf lengths. */
const NUDGE = 0.005;

/** Returns the edit that a key causes; undefined where it causes none. */
export function pressed(
	points: OutlinePoints,
	chosen: number,
	{ key, shiftKey }: Pick<KeyboardEvent, "key" | "shiftKey">,
	symmetry: Symmetry,
): Step | undefined {
	const last = points.length - 1;
	if (key in ARROWS) return nudged(points, chosen, ARROWS[key], shiftKey ? 10 * NUDGE : NUDGE, symmetry);
	if (key === "PageDown") return { chosen: chosen === last ? 1 : chosen + 1, message: "" };
	if (key === "PageUp") return { chosen: chosen === 1 ? last : chosen - 1, message: "" };
	if (key === "Insert" || key === "+") return inserted(points, chosen, symmetry);
	if (key === "Delete" || key === "Backspace") return removed(points, chosen, symmetry);
	return key === "t" || key === "T" ? turned(points, chosen, symmetry) : undefined;
}

/**
 * Moves the chosen point by a step in a direction, unless the outline would cross itself.
 * @param step in leaf lengths
 */
function nudged(points: OutlinePoints, chosen: number, direction: Place, step: number, symmetry: Symmetry): Step {
	const { x, y } = points[chosen];
	const after = movePoint(points, chosen, { x: x + step * direction.x, y: y + step * direction.y }, symmetry);
	return unlessCrossing({ points: after, chosen, message: placeInWords(after[chosen]) });
}

/** Changes the chosen point to the next kind, unless the outline would cross itself. */
export function turned(points: OutlinePoints, chosen: number, symmetry: Symmetry): Step {
	const outlineAfter = turnKind(points, chosen, symmetry);
	return unlessCrossing({ points: outlineAfter, chosen, message: kindInWords(outlineAfter[chosen].kind) });
}

/** Inserts a point behind point `after`: halfway to the next point, or at the position `at` near the curve. */
export function inserted(points: OutlinePoints, after: number, symmetry: Symmetry, at?: Place): Step {
	const outlineAfter = insertPoint(points, after, at ?? placeOn(spansOf(points)[after], 0.5), symmetry);
	if (outlineAfter.length === points.length) return { message: text("no_room") };
	return unlessCrossing({
		points: outlineAfter,
		chosen: insertedAt(points.length, after, symmetry),
		message: text("point_added"),
	});
}

/** Removes the chosen point; without a change, and with a message, where too few would be left. */
export function removed(points: OutlinePoints, chosen: number, symmetry: Symmetry): Step {
	const outlineAfter = removePoint(points, chosen, symmetry);
	if (outlineAfter.length === points.length) return { message: text("points_needed") };
	return unlessCrossing({
		points: outlineAfter,
		chosen: Math.min(chosen, outlineAfter.length - 1),
		message: text("point_removed"),
	});
}

/** Rejects an edit after which the outline would not enclose a blade. */
function unlessCrossing(step: Step): Step {
	if (!step.points || enclosesBlade(step.points)) return step;
	return { message: text("would_cross") };
}
