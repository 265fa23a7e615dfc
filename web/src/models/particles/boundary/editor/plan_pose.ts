/** Grips of the view from above: boundary, obstacles and targets. */

import { lengthInWords } from "../../../../plant/in_words";
import type { BoundedSpecimen } from "../bounded";
import { editableState, type GripWithoutKeys, withArrowKeys } from "./arrow_keys";
import { axisOf, type BoundaryLayout, LEAST } from "./boundary_layout";
import { FROM_ABOVE } from "./facing";
import type { Pose } from "./grip";
import { sideGrip } from "./size_grips";
import { targetGrips } from "./target_grips";
import { wallGrips } from "./walls";

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

function frontGrip<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S, preset: S): GripWithoutKeys {
	const deep = layout.halfDepth(specimen);
	return {
		id: "front",
		at: { x: axisOf(layout, specimen), y: -deep },
		label: "Depth",
		value: `${lengthInWords(2 * deep)} front to back`,
		pull: ({ y }) => ({ parameters: layout.deepen(specimen, Math.max(LEAST / 2, -y)) }),
		reset: () => ({ parameters: layout.deepen(specimen, layout.halfDepth(preset)) }),
	};
}
