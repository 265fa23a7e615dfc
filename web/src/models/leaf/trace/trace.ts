/** Traces a picture of a leaf: the points of its outline, and its petiole. Pure; errors have messages for users. */

import { contourOf, smoothed } from "../../../import/tracing/contour";
import { type PixelImage, TraceError } from "../../../import/tracing/picture";
import { silhouetteOf } from "../../../import/tracing/silhouette";
import { withoutStalk } from "../../../import/tracing/stalk";
import { upright } from "../../../import/tracing/upright";
import { text } from "../messages.generated";
import { FEWEST_POINTS, type LeafKind, type OutlinePoint, type Place, placed } from "../outline/points";
import { enclosesBlade } from "../outline/spline";

/** Most points of a traced outline. */
export const MAX_TRACED = 48;
/** Least tolerance of the simplification, in leaf lengths. */
const FINEST = 0.004;
/** Share of the margin to either side over which an angle is measured. */
const ARM = 0.018;
/** Largest angle of a sharp point, radians. */
const SHARP = (118 / 180) * Math.PI;
/** Least height of a lobe, in leaf lengths; lower tips are teeth. */
const LOBE = 0.09;
/** Distance along the margin from a lobe's tip to its base, as a share of the margin. */
const LOBE_REACH = 0.07;

export interface TracedLeaf {
	outline: OutlinePoint[];
	/** The petiole, in leaf lengths; absent where the picture shows none. */
	petiole?: { length: number; width: number };
}

/**
 * Traces a leaf: separates blade and petiole, turns the blade's tip up, and simplifies its margin to points.
 * @throws TraceError
 */
export function traceLeaf(picture: PixelImage): TracedLeaf {
	const { blade, base, stalk } = withoutStalk(silhouetteOf(picture, "leaf"));
	const steps = contourOf(blade);
	const { margin, size } = upright(smoothed(steps, Math.max(1, 0.002 * steps.length)), base);
	const petiole = stalk && { length: stalk.length / size, width: stalk.width / size };
	return { outline: pointsOf(margin), ...(petiole && { petiole }) };
}

/**
 * Simplifies the traced margin with growing tolerance until at most MAX_TRACED points are left. The first point is at
 * the petiole.
 * @throws TraceError if too few points are left, or if they enclose no blade
 */
function pointsOf(margin: readonly Place[]): OutlinePoint[] {
	for (let tolerance = FINEST; tolerance < 0.1; tolerance *= 1.25) {
		const corners = simplify(margin, tolerance);
		if (corners.length > MAX_TRACED) continue;
		const points = corners.map((index): OutlinePoint => ({ ...placed(margin[index]), kind: kindOf(margin, index) }));
		points[0] = { x: 0, y: 0, kind: "corner" };
		if (points.length >= FEWEST_POINTS && enclosesBlade(points)) return points;
	}
	throw new TraceError(text("trace_failed"));
}

/**
 * Simplifies a closed polygon within a tolerance in leaf lengths (Ramer 1972, Douglas and Peucker 1973). Returns the
 * indices of the remaining points; the first is 0.
 */
function simplify(polygon: readonly Place[], tolerance: number): number[] {
	const tip = polygon.reduce((best, { y }, index) => (y > polygon[best].y ? index : best), 0);
	const indices = new Set([0, tip]);
	/**
	 * Splits the chord between two indices at the farthest point, recursively, until no point is farther than the
	 * tolerance.
	 */
	const split = (from: number, to: number) => {
		const [a, b] = [polygon[from], polygon[to % polygon.length]];
		let [farthest, at] = [tolerance, -1];
		for (let index = from + 1; index < to; index++) {
			const distance = distanceFromChord(polygon[index], a, b);
			if (distance > farthest) [farthest, at] = [distance, index];
		}
		if (at < 0) return;
		indices.add(at);
		split(from, at);
		split(at, to);
	};
	split(0, tip);
	split(tip, polygon.length);
	return [...indices].sort((a, b) => a - b);
}

/**
 * Returns the distance of a point from the segment a b: the nearest point is at parameter t, 0 … 1, of the segment.
 */
function distanceFromChord({ x, y }: Place, a: Place, b: Place): number {
	const [dx, dy] = [b.x - a.x, b.y - a.y];
	const squaredLength = dx * dx + dy * dy;
	const t = squaredLength === 0 ? 0 : Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / squaredLength));
	return Math.hypot(x - a.x - t * dx, y - a.y - t * dy);
}

/**
 * Returns the kind of a point of the margin: a sharp protruding point is the tip of a lobe, another sharp point a
 * corner.
 */
function kindOf(margin: readonly Place[], index: number): LeafKind {
	const at = (share: number) => {
		const { length } = margin;
		return margin[(index + Math.round(share * length) + length) % length];
	};
	const [before, here, after] = [at(-ARM), margin[index], at(ARM)];
	const angleBefore = Math.atan2(before.y - here.y, before.x - here.x);
	const angleAfter = Math.atan2(after.y - here.y, after.x - here.x);
	const angle = (angleAfter - angleBefore + 4 * Math.PI) % (2 * Math.PI);
	// Counter-clockwise, the inside is on the left: at a tip it is between `after` and `before`.
	const convex = angle > Math.PI;
	const innerAngle = convex ? 2 * Math.PI - angle : angle;
	if (innerAngle > SHARP) return "smooth";
	return convex && distanceFromChord(here, at(-LOBE_REACH), at(LOBE_REACH)) > LOBE ? "pointed" : "corner";
}
