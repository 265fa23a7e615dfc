/** What the grips of every flat view of a boundary share: their arrow keys, and what they can change. */

import { onStep } from "../../../../specimen/table";
import type { Change } from "../../../../ui/editor_context";
import type { BoundedSpecimen } from "../bounded";
import { type BoundaryLayout, sizeOf } from "./boundary_layout";
import type { Grip } from "./grip";

/** What an arrow key moves, as a share of the boundary's size; with Shift ten times that. */
const NUDGE = 0.01;
/** The least of it, metres. */
const LEAST_STEP = 0.01;

export type GripWithoutKeys = Omit<Grip, "nudge">;

/** The same with arrow keys. */
export function withArrowKeys<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	grips: readonly GripWithoutKeys[],
): Grip[] {
	const step = (large: boolean) =>
		Math.max(LEAST_STEP, onStep(NUDGE * sizeOf(layout.box(specimen)) * (large ? 10 : 1)));
	return grips.map((grip) => ({
		...grip,
		nudge: (right, up, large) => grip.pull({ x: grip.at.x + right * step(large), y: grip.at.y + up * step(large) }),
	}));
}

/** All that grips can change of a specimen, as it is. */
export function editableState({ parameters, profile, obstacles, rounds, targets }: BoundedSpecimen): Change {
	return { parameters, details: { profile, obstacles, rounds, targets } };
}
