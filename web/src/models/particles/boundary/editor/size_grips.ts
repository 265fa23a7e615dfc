/** Grips of the ends and the side of a boundary's box. */

import { lengthInWords } from "../../../../plant/in_words";
import type { Change } from "../../../../ui/editor_context";
import { text } from "../../messages.generated";
import type { BoundedSpecimen } from "../bounded";
import type { GripWithoutKeys } from "./arrow_keys";
import { axisOf, type BoundaryLayout, type Box, LEAST } from "./boundary_layout";

type End = "low" | "high";

/** Returns the grips, from the top down. */
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

/** Returns the grip of the upper or the lower end. */
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

/** Returns the grip of the width, at the widest height of the boundary. */
export function sideGrip<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
): GripWithoutKeys {
	const box = layout.box(specimen);
	const axis = axisOf(layout, specimen);
	const withHalfWidth = (halfWidth: number): Change => ({ parameters: layout.fit(specimen, { ...box, halfWidth }) });
	return {
		id: "side",
		at: { x: axis + box.halfWidth, y: box.low + widestHeight(layout, specimen) * (box.high - box.low) },
		label: text("width"),
		value: text("width_value", { length: lengthInWords(2 * box.halfWidth) }),
		pull: (to) => withHalfWidth(Math.max(LEAST / 2, Math.abs(to.x - axis))),
		reset: () => withHalfWidth(layout.box(preset).halfWidth),
	};
}

/** Returns the change that moves one end of the box to a height in metres; the other end stays. */
export function withEnd<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	end: End,
	y: number,
): Change {
	const box = layout.box(specimen);
	const newHeight = end === "high" ? Math.max(y, box.low + LEAST) : Math.min(y, box.high - LEAST);
	return { parameters: layout.fit(specimen, { ...box, [end]: newHeight }) };
}

/**
 * Returns the change that resets one end to the preset: the end at the ground to its height there, the other end to its
 * distance from that one.
 */
export function withPresetsEnd<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
	end: End,
): Change {
	const [box, presetBox] = [layout.box(specimen), layout.box(preset)];
	const fixedEnd: End = groundEnd(presetBox);
	return withEnd(
		layout,
		specimen,
		end,
		end === fixedEnd ? presetBox[fixedEnd] : box[fixedEnd] + presetBox[end] - presetBox[fixedEnd],
	);
}

/** Returns the end of the box that is at the ground: the lower one of crowns, the upper one of roots. */
const groundEnd = ({ high }: Box): End => (high > 0 ? "low" : "high");

/** Describes a height in metres: "3 m up" or "40 cm below ground". */
export function heightInWords(height: number): string {
	return text(height < 0 ? "below_ground" : "up", { length: lengthInWords(Math.abs(height)) });
}

/** Returns the height at which the boundary is widest, as a share of its height. */
function widestHeight<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): number {
	const form = layout.form(specimen);
	return form === "cone" ? 0 : form === "bowl" || form === "coneDown" ? 1 : 0.5;
}
