/** Grips of the points of a profile. */

import { lengthInWords } from "../../../../plant/in_words";
import type { Change } from "../../../../ui/editor_context";
import type { Point } from "../../../../ui/handles/point";
import { text } from "../../messages.generated";
import type { BoundedSpecimen, Knot } from "../bounded";
import { FEWEST_KNOTS, knotAt, MAX_KNOTS } from "../details/profile";
import type { GripWithoutKeys } from "./arrow_keys";
import { axisOf, type BoundaryLayout, outlineIn } from "./boundary_layout";
import { radiusAt } from "./outline";
import { heightInWords, withEnd, withPresetsEnd } from "./size_grips";

/** Returns the handles of the points of a boundary's profile. */
export function knotGrips<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
): GripWithoutKeys[] {
	const { halfWidth, low, high } = layout.box(specimen);
	const axis = axisOf(layout, specimen);
	const knots = knotsOf(layout, specimen);
	return knots.map(([radius, height], i) => {
		const at = { x: axis + radius * halfWidth, y: low + height * (high - low) };
		const inner = i > 0 && i < knots.length - 1;
		return {
			id: `knot${i}`,
			at,
			label: text("point", { number: i + 1 }),
			value: text("point_value", { length: lengthInWords(radius * halfWidth), height: heightInWords(at.y) }),
			pull: (to) => changeByPull(layout, specimen, i, to),
			reset: () => changeToPresetKnot(layout, specimen, preset, i),
			...(inner && knots.length > FEWEST_KNOTS ? { remove: () => changeToProfile(knots.toSpliced(i, 1)) } : {}),
			...(knots.length < MAX_KNOTS
				? { add: () => changeByInsertion(layout, specimen, Math.min(i, knots.length - 2)) }
				: {}),
		};
	});
}

/** Returns the points of the profile: the specimen's own or the layout's default. */
function knotsOf<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, { profile }: S): readonly Knot[] {
	return profile ?? layout.profile;
}

/** Returns the change that sets the profile. */
const changeToProfile = (profile: Knot[]): Change => ({ details: { profile } });

/** Returns the end of the box that moves with a point; undefined for points between the ends. */
function endOf(knots: readonly Knot[], index: number): "low" | "high" | undefined {
	return index === 0 ? "low" : index === knots.length - 1 ? "high" : undefined;
}

/**
 * Returns the profile with one point moved, limited to the heights of its neighbours.
 * @param radius in half widths
 * @param height as a share of the box's height
 */
function withKnotMoved(knots: readonly Knot[], index: number, radius: number, height: number): Knot[] {
	const [below, above] = [knots[index - 1]?.[1] ?? 0, knots[index + 1]?.[1] ?? 1];
	return knots.toSpliced(index, 1, knotAt(radius, Math.min(Math.max(height, below), above)));
}

/**
 * Returns the change that moves a point of the profile to a position in metres. An end point moves the box's end as
 * well.
 */
function changeByPull<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	index: number,
	to: Point,
): Change {
	const box = layout.box(specimen);
	const knots = knotsOf(layout, specimen);
	const radius = Math.max(0, to.x - axisOf(layout, specimen)) / box.halfWidth;
	const end = endOf(knots, index);
	if (!end) return changeToProfile(withKnotMoved(knots, index, radius, (to.y - box.low) / (box.high - box.low)));
	// The point keeps its share of the height: the end of the box moves so far that the point is at the pointer.
	const [other, share] = end === "high" ? [box.low, knots[index][1]] : [box.high, 1 - knots[index][1]];
	const y = share > 0 ? other + (to.y - other) / share : box[end];
	return {
		...changeToProfile(withKnotMoved(knots, index, radius, knots[index][1])),
		...withEnd(layout, specimen, end, y),
	};
}

/**
 * Returns the change back to the preset's point; undefined where the preset has no such point: another shape, or
 * another number of points.
 */
function changeToPresetKnot<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
	index: number,
): Change | undefined {
	if (layout.form(preset) !== "spline") return undefined;
	const [knots, before] = [knotsOf(layout, specimen), knotsOf(layout, preset)];
	const end = endOf(knots, index);
	if (!end)
		return knots.length === before.length ? changeToProfile(withKnotMoved(knots, index, ...before[index])) : undefined;
	const was = end === "low" ? before[0] : before[before.length - 1];
	return { ...changeToProfile(withKnotMoved(knots, index, ...was)), ...withPresetsEnd(layout, specimen, preset, end) };
}

/** Returns the change that adds a point on the curve, halfway in height between a point and the next one. */
function changeByInsertion<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S, index: number): Change {
	const knots = knotsOf(layout, specimen);
	const height = (knots[index][1] + knots[index + 1][1]) / 2;
	return changeToProfile(knots.toSpliced(index + 1, 0, knotAt(radiusAt(outlineIn(layout, specimen), height), height)));
}

/** Heights of the sample points when another shape is converted to a profile, in shares of the box. */
const TAKEN = [0.02, 0.15, 0.4, 0.65, 0.88, 1];

/** Converts the present boundary to an editable profile: its radii at the heights TAKEN. */
export function asProfile<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): Knot[] {
	const outline = outlineIn(layout, specimen);
	return TAKEN.map((height, i) => knotAt(radiusAt(outline, height), i === 0 ? 0 : height));
}
