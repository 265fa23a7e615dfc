/** The grips of a boundary seen from the front. */

import { lengthInWords } from "../../../../plant/in_words";
import type { Point } from "../../../../ui/handles/point";
import { text } from "../../messages.generated";
import type { BoundedSpecimen } from "../bounded";
import { editableState, type GripWithoutKeys, withArrowKeys } from "./arrow_keys";
import { axisOf, type BoundaryLayout, LEAST, outlineIn, sizeOf } from "./boundary_layout";
import { FROM_FRONT } from "./facing";
import type { Pose } from "./grip";
import { knotGrips } from "./knot_grips";
import { radiusAt } from "./outline";
import { sizeGrips } from "./size_grips";
import { targetGrips } from "./target_grips";
import { wallGrips } from "./walls";

/** Share of the boundary's size below which a dragged target snaps to the ground. */
const GROUND = 0.05;

/** Returns all handles of a boundary: its shape, inner boundary, distance, walls and targets. */
export function boundaryPose<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S, preset: S): Pose {
	const shape = layout.form(specimen) === "spline" ? knotGrips : sizeGrips;
	const own = [
		...shape(layout, specimen, preset),
		innerGrip(layout, specimen, preset),
		...distanceGrip(layout, specimen, preset),
		...wallGrips(specimen, FROM_FRONT),
	];
	const feet = withArrowKeys(layout, specimen, targetGrips(layout, specimen, preset, FROM_FRONT));
	// Dragging along the ground does not lift a target slightly; arrow keys do.
	const near = GROUND * sizeOf(layout.box(specimen));
	const grounded = ({ x, y }: Point): Point => ({ x, y: Math.abs(y) < near ? 0 : y });
	return {
		grips: [
			...withArrowKeys(layout, specimen, own),
			...feet.map((foot) => ({ ...foot, pull: (to: Point) => foot.pull(grounded(to)) })),
		],
		change: editableState(specimen),
	};
}

/** Returns the grip at the left of the inner boundary, at half the height of the outer one. */
function innerGrip<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S, preset: S): GripWithoutKeys {
	const box = layout.box(specimen);
	const axis = axisOf(layout, specimen);
	const { inner } = specimen.parameters;
	const about = layout.bareAbout(box);
	/** Half width of the boundary at half its height, metres. */
	const waist = box.halfWidth * Math.max(LEAST, radiusAt(outlineIn(layout, specimen), 0.5));
	return {
		id: "inner",
		at: { x: axis - inner * waist, y: about + inner * ((box.low + box.high) / 2 - about) },
		label: text("inner"),
		value: inner > 0 ? text("inner_share", { percent: Math.round(100 * inner) }) : text("inner_none"),
		pull: ({ x }) => {
			const out = Math.abs(x - axis);
			return { parameters: { inner: out > LEAST ? out / waist : 0 } };
		},
		reset: () => ({ parameters: { inner: preset.parameters.inner } }),
	};
}

/** Returns the grip that moves the axes apart; none for a single axis. */
function distanceGrip<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S, preset: S): GripWithoutKeys[] {
	const x = axisOf(layout, specimen);
	if (!layout.move?.(specimen, x)) return [];
	const { low, high } = layout.box(specimen);
	return [
		{
			id: "axis",
			at: { x, y: low + 0.75 * (high - low) },
			label: text("distance"),
			value: text("distance_apart", { length: lengthInWords(specimen.parameters.distance) }),
			pull: (to) => ({ parameters: layout.move?.(specimen, to.x) ?? {} }),
			reset: () => ({ parameters: { distance: preset.parameters.distance } }),
		},
	];
}
