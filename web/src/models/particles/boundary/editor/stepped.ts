/** What the grips of every flat view of a boundary share: their arrow keys, and what they can change. */

import { onStep } from "../../../../specimen/table";
import type { Change } from "../../../../ui/editor_context";
import type { BoundedSpecimen } from "../bounded";
import type { Grip } from "./grip";
import { type Lay, sizeOf } from "./lay";

/** What an arrow key moves, as a share of the boundary's size; with Shift ten times that. */
const NUDGE = 0.01;
/** The least of it, metres. */
const LEAST_STEP = 0.01;

export type Unstepped = Omit<Grip, "nudge">;

/** The same with arrow keys. */
export function stepped<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, grips: readonly Unstepped[]): Grip[] {
	const step = (large: boolean) => Math.max(LEAST_STEP, onStep(NUDGE * sizeOf(lay.box(specimen)) * (large ? 10 : 1)));
	return grips.map((grip) => ({
		...grip,
		nudge: (right, up, large) => grip.pull({ x: grip.at.x + right * step(large), y: grip.at.y + up * step(large) }),
	}));
}

/** All that grips can change of a specimen, as it is. */
export function standing({ parameters, profile, obstacles, rounds, targets }: BoundedSpecimen): Change {
	return { parameters, details: { profile, obstacles, rounds, targets } };
}
