/** Grips of the view from above: boundary, obstacles and targets. */

import { lengthInWords } from "../../../../plant/in_words";
import { text } from "../../messages.generated";
import type { BoundedSpecimen } from "../bounded";
import { editableState, type GripWithoutKeys, withArrowKeys } from "./arrow_keys";
import { axisOf, type BoundaryLayout, LEAST } from "./boundary_layout";
import { FROM_ABOVE } from "./facing";
import type { Pose } from "./grip";
import { sideGrip } from "./size_grips";
import { targetGrips } from "./target_grips";
import { wallGrips } from "./walls";

/** Returns the grips, in metres: x to the right, y to the back. */
export function planPose<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S, preset: S): Pose {
	const side = sideGrip(layout, specimen, preset);
	const grips = [
		{ ...side, at: { x: side.at.x, y: 0 } },
		frontGrip(layout, specimen, preset),
		...wallGrips(specimen, FROM_ABOVE),
		...targetGrips(layout, specimen, preset, FROM_ABOVE),
	];
	return { grips: withArrowKeys(layout, specimen, grips), change: editableState(specimen) };
}

/** Returns the grip at the front, which sets the depth. */
function frontGrip<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S, preset: S): GripWithoutKeys {
	const halfDepth = layout.halfDepth(specimen);
	return {
		id: "front",
		at: { x: axisOf(layout, specimen), y: -halfDepth },
		label: text("depth"),
		value: text("depth_value", { length: lengthInWords(2 * halfDepth) }),
		pull: ({ y }) => ({ parameters: layout.deepen(specimen, Math.max(LEAST / 2, -y)) }),
		reset: () => ({ parameters: layout.deepen(specimen, layout.halfDepth(preset)) }),
	};
}
