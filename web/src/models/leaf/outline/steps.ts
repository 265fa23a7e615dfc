/** Edits of the chosen point by keys and buttons, each with a message for screen readers. Pure functions. */
import { ARROWS } from "../../../ui/handles/point";
import { CROSSES, KIND_WORDS, placeInWords } from "./outline_words";
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

/** The edit that a key causes; undefined where it causes none. */
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

function nudged(points: OutlinePoints, chosen: number, way: Place, by: number, symmetry: Symmetry): Step {
	const { x, y } = points[chosen];
	const moved = movePoint(points, chosen, { x: x + by * way.x, y: y + by * way.y }, symmetry);
	return sound({ points: moved, chosen, message: placeInWords(moved[chosen]) });
}

/** Changes the chosen point to the next kind. */
export function turned(points: OutlinePoints, chosen: number, symmetry: Symmetry): Step {
	const next = turnKind(points, chosen, symmetry);
	return sound({ points: next, chosen, message: KIND_WORDS[next[chosen].kind] });
}

/** Inserts a point halfway to the next, or at a position near the curve. */
export function inserted(points: OutlinePoints, after: number, symmetry: Symmetry, at?: Place): Step {
	const next = insertPoint(points, after, at ?? placeOn(spansOf(points)[after], 0.5), symmetry);
	if (next.length === points.length) return { message: "There is no room for more points" };
	return sound({ points: next, chosen: insertedAt(points.length, after, symmetry), message: "Point added" });
}

export function removed(points: OutlinePoints, chosen: number, symmetry: Symmetry): Step {
	const next = removePoint(points, chosen, symmetry);
	if (next.length === points.length) return { message: "The last points stay" };
	return sound({ points: next, chosen: Math.min(chosen, next.length - 1), message: "Point removed" });
}

/** Rejects an edit after which the outline would not enclose a blade. */
function sound(step: Step): Step {
	if (!step.points || enclosesBlade(step.points)) return step;
	return { message: CROSSES };
}
