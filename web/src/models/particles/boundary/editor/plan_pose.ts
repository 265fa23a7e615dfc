/** The grips of a plan: the boundary, its obstacles and its targets from above. */

import { lengthInWords } from "../../../../plant/in_words";
import type { BoundedSpecimen } from "../bounded";
import { FROM_ABOVE } from "./facing";
import { footGrips } from "./feet";
import type { Pose } from "./grip";
import { axisOf, type Lay, LEAST } from "./lay";
import { sideGrip } from "./size_grips";
import { standing, stepped, type Unstepped } from "./stepped";
import { wallGrips } from "./walls";

export function planPose<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S): Pose {
	const side = sideGrip(lay, specimen, preset);
	const grips = [
		{ ...side, at: { x: side.at.x, y: 0 } },
		frontGrip(lay, specimen, preset),
		...wallGrips(specimen, FROM_ABOVE),
		...footGrips(lay, specimen, preset, FROM_ABOVE),
	];
	return { grips: stepped(lay, specimen, grips), change: standing(specimen) };
}

function frontGrip<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S): Unstepped {
	const deep = lay.halfDepth(specimen);
	return {
		id: "front",
		at: { x: axisOf(lay, specimen), y: -deep },
		label: "Depth",
		value: `${lengthInWords(2 * deep)} front to back`,
		pull: ({ y }) => ({ parameters: lay.deepen(specimen, Math.max(LEAST / 2, -y)) }),
		reset: () => ({ parameters: lay.deepen(specimen, lay.halfDepth(preset)) }),
	};
}
