/** Texts of the editor about points. */
import { text } from "../messages.generated";
import type { LeafKind, OutlinePoint } from "./points";

/** Returns the name of a kind of points: "corner". */
export const kindInWords = (kind: LeafKind): string => text("kind", { kind });

/** Describes a position in percent of the leaf's length: "31 % right, 45 % up". */
export function placeInWords({ x, y }: OutlinePoint): string {
	const [across, up] = [x, y].map((value) => Math.round(1000 * value) / 10);
	return text("place", {
		side: across === 0 ? "middle" : across > 0 ? "right" : "left",
		across: Math.abs(across),
		level: up < 0 ? "below" : "up",
		up: Math.abs(up),
	});
}

/** Describes a point: "Point 5 of 36, corner: 31 % right, 45 % up". */
export function pointInWords(points: readonly OutlinePoint[], index: number): string {
	const point = points[index];
	return text("point_described", {
		number: index,
		count: points.length - 1,
		kind: kindInWords(point.kind),
		place: placeInWords(point),
	});
}
