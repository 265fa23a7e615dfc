/** Arrow keys and editable fields, common to the grips of all flat views of a boundary. */

import { onStep } from "../../../../specimen/table";
import type { Change } from "../../../../ui/editor_context";
import type { BoundedSpecimen } from "../bounded";
import { type BoundaryLayout, sizeOf } from "./boundary_layout";
import type { Grip } from "./grip";

/** Step of an arrow key, as a share of the boundary's size; Shift multiplies it by ten. */
const NUDGE = 0.01;
/** Least step, metres. */
const LEAST_STEP = 0.01;

export type GripWithoutKeys = Omit<Grip, "nudge">;

/** Adds to grips the changes that arrow keys cause: a move by a share of the boundary's size. */
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

/** Returns the present values of all fields that grips can change. */
export function editableState({ parameters, profile, obstacles, rounds, targets }: BoundedSpecimen): Change {
	return { parameters, details: { profile, obstacles, rounds, targets } };
}
