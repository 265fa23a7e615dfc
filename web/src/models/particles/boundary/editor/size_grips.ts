/** Grips of the ends and the side of a boundary's box. */

import { lengthInWords } from "../../../../plant/in_words";
import type { Change } from "../../../../ui/editor_context";
import type { BoundedSpecimen } from "../bounded";
import type { GripWithoutKeys } from "./arrow_keys";
import { axisOf, type BoundaryLayout, type Box, LEAST } from "./boundary_layout";

type End = "low" | "high";

export function sizeGrips<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
): GripWithoutKeys[] {
	return [
		endGrip(layout, specimen, preset, "high"),
		sideGrip(layout, specimen, preset),
		endGrip(layout, specimen, preset, "low"),
	];
}

function endGrip<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
	end: End,
): GripWithoutKeys {
	const y = layout.box(specimen)[end];
	return {
		id: end,
		at: { x: axisOf(layout, specimen), y },
		label: layout.ends[end],
		value: heightInWords(y),
		pull: (to) => withEnd(layout, specimen, end, to.y),
		reset: () => withPresetsEnd(layout, specimen, preset, end),
	};
}

/** The grip of the width, at the widest height of the boundary. */
export function sideGrip<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
): GripWithoutKeys {
	const box = layout.box(specimen);
	const axis = axisOf(layout, specimen);
	const sized = (halfWidth: number): Change => ({ parameters: layout.fit(specimen, { ...box, halfWidth }) });
	return {
		id: "side",
		at: { x: axis + box.halfWidth, y: box.low + shoulderOf(layout, specimen) * (box.high - box.low) },
		label: "Width",
		value: `${lengthInWords(2 * box.halfWidth)} wide`,
		pull: (to) => sized(Math.max(LEAST / 2, Math.abs(to.x - axis))),
		reset: () => sized(layout.box(preset).halfWidth),
	};
}

/** Moves one end of the box to a height; the other end stays. */
export function withEnd<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	end: End,
	y: number,
): Change {
	const box = layout.box(specimen);
	const at = end === "high" ? Math.max(y, box.low + LEAST) : Math.min(y, box.high - LEAST);
	return { parameters: layout.fit(specimen, { ...box, [end]: at }) };
}

/**
 * Resets one end to the preset: the end at the ground to its height there, the other end to its distance from that
 * one.
 */
export function withPresetsEnd<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
	end: End,
): Change {
	const [box, before] = [layout.box(specimen), layout.box(preset)];
	const near: End = atGround(before);
	return withEnd(layout, specimen, end, end === near ? before[near] : box[near] + before[end] - before[near]);
}

const atGround = ({ high }: Box): End => (high > 0 ? "low" : "high");

export function heightInWords(height: number): string {
	return `${lengthInWords(Math.abs(height))} ${height < 0 ? "below ground" : "up"}`;
}

/** The height of the widest place, as a share of the boundary's height. */
function shoulderOf<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): number {
	const form = layout.form(specimen);
	return form === "cone" ? 0 : form === "bowl" || form === "coneDown" ? 1 : 0.5;
}
