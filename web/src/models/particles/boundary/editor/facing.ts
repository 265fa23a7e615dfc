/** From where a flat view looks, and what is up in it. */

import { lengthInWords } from "../../../../plant/in_words";
import type { Point } from "../../../../ui/handles/point";

export interface Facing {
	/** The coordinate that is up, and whether it grows that way. */
	readonly up: 1 | 2;
	readonly sign: 1 | -1;
}

export const FROM_FRONT: Facing = { up: 1, sign: 1 };
/** What is in front is below. */
export const FROM_ABOVE: Facing = { up: 2, sign: -1 };

/** Where a place (x, y, z) is seen. */
export function seen(place: readonly number[], { up, sign }: Facing): Point {
	return { x: place[0], y: sign * place[up] + 0 };
}

/** A place moved to where it is seen; what the view does not show stays. */
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
