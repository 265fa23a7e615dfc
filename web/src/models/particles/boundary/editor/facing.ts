/** Directions of the flat views. */

import { lengthInWords } from "../../../../plant/in_words";
import type { Point } from "../../../../ui/handles/point";

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

/** "2.1 m right, 30 cm up". */
export function placeInWords(place: readonly number[], { up }: Facing): string {
	const part = (value: number, below: string, above: string) =>
		Math.abs(value) < 0.005 ? "" : `${lengthInWords(Math.abs(value))} ${value < 0 ? below : above}`;
	const across = part(place[0], "left", "right");
	const other = up === 1 ? part(place[1], "below ground", "up") : part(place[2], "behind", "in front");
	return [across, other].filter(Boolean).join(", ") || "in the middle";
}
