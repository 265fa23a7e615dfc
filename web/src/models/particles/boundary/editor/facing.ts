/** Directions of the flat views. */

import { lengthInWords } from "../../../../plant/in_words";
import type { Point } from "../../../../ui/handles/point";
import { text } from "../../messages.generated";

export interface Facing {
	/** The axis that points up in the view, and whether it points in the positive direction. */
	readonly up: 1 | 2;
	readonly sign: 1 | -1;
}

export const FROM_FRONT: Facing = { up: 1, sign: 1 };
/** From above, with the front at the bottom. */
export const FROM_ABOVE: Facing = { up: 2, sign: -1 };

/** Projects a point (x, y, z) to the view. */
export function seen(place: readonly number[], { up, sign }: Facing): Point {
	return { x: place[0], y: sign * place[up] + 0 };
}

/** Moves a point to a position in the view; the hidden coordinate stays. */
export function moved(place: readonly number[], to: Point, { up, sign }: Facing): number[] {
	return place.map((value, k) => (k === 0 ? to.x : k === up ? sign * to.y : value));
}

type Direction = "left" | "right" | "up" | "below_ground" | "behind" | "in_front";

/** Describes a position as seen in a view, metres: "2.1 m right, 30 cm up". */
export function placeInWords(place: readonly number[], { up }: Facing): string {
	const inWords = (value: number, below: Direction, above: Direction) =>
		Math.abs(value) < 0.005 ? "" : text(value < 0 ? below : above, { length: lengthInWords(Math.abs(value)) });
	const horizontal = inWords(place[0], "left", "right");
	const vertical = up === 1 ? inWords(place[1], "below_ground", "up") : inWords(place[2], "behind", "in_front");
	return [horizontal, vertical].filter(Boolean).join(", ") || text("in_the_middle");
}
