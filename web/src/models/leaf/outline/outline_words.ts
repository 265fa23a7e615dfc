/** Texts of the editor about points. */
import type { LeafKind, OutlinePoint } from "./points";

export const KIND_WORDS: Readonly<Record<LeafKind, string>> = {
	smooth: "smooth",
	corner: "corner",
	lobe: "rounded lobe tip",
	pointed: "pointed lobe tip",
};

/** "31 % right, 45 % up", of the leaf's length. */
export function placeInWords({ x, y }: OutlinePoint): string {
	const [across, up] = [x, y].map((value) => Math.round(1000 * value) / 10);
	const sideways = across === 0 ? "in the middle" : `${Math.abs(across)} % ${across > 0 ? "right" : "left"}`;
	return `${sideways}, ${Math.abs(up)} % ${up < 0 ? "below" : "up"}`;
}

/** "Point 5 of 36, corner: 31 % right, 45 % up". */
export function pointInWords(points: readonly OutlinePoint[], index: number): string {
	const point = points[index];
	return `Point ${index} of ${points.length - 1}, ${KIND_WORDS[point.kind]}: ${placeInWords(point)}`;
}

/** Message where an edit would make the outline cross itself. */
export const CROSSES = "The outline would cross itself";

export const HELP =
	"Drag, or use the arrow keys: half a hundredth of the leaf a step, ten times that with Shift. Page keys go to the next point and the one before, Insert puts one in, Delete takes it out, T changes its kind. Escape calls off a drag.";
