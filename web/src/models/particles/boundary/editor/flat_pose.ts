/** What all flat views of a boundary have in common: obstacles and targets beside what each has of its own, and arrow keys. */
import type { Change } from "../../../../controls/desk";
import type { Point } from "../../../../controls/handles/point";
import { onStep } from "../../../../specimen/table";
import type { BoundedSpecimen } from "../bounded";
import type { Facing } from "./facing";
import { footGrips, footIn, pullFoot, resetFoot, withoutFoot } from "./feet";
import type { Grip, Pose } from "./grip";
import type { Lay } from "./lay";
import { isWall, pullWall, wallGrips } from "./walls";

/** What an arrow key moves, as a share of the boundary's size; with Shift ten times that. */
const NUDGE = 0.01;

/** What a view has besides obstacles and targets. */
export interface Own extends Omit<Pose, "nudge"> {
	/** Where a hand that drags a target takes it to; there, where this is not told. */
	grounded?(to: Point): Point;
}

export function flatPose<S extends BoundedSpecimen>(
	facing: Facing,
	lay: Lay<S>,
	specimen: S,
	preset: S,
	own: Own,
): Pose {
	const grips: Grip[] = [...own.grips, ...wallGrips(specimen, facing), ...footGrips(lay, specimen, facing)];
	const pull = (id: string, to: Point): Change => {
		const foot = footIn(id);
		if (foot !== undefined) return pullFoot(lay, specimen, foot, to, facing);
		return isWall(id) ? pullWall(specimen, id, to, facing) : own.pull(id, to);
	};
	return {
		...own,
		grips,
		pull: (id, to) => pull(id, footIn(id) === undefined ? to : (own.grounded?.(to) ?? to)),
		nudge: (id, right, up, large) => {
			const grip = grips.find((each) => each.id === id);
			const step = stepOf(lay, specimen, large);
			return grip && pull(id, { x: grip.at.x + right * step, y: grip.at.y + up * step });
		},
		reset: (id) => {
			const foot = footIn(id);
			return foot === undefined ? own.reset?.(id) : resetFoot(lay, specimen, preset, foot);
		},
		remove: (id) => {
			const foot = footIn(id);
			return foot === undefined ? own.remove?.(id) : withoutFoot(lay, specimen, foot);
		},
	};
}

/** A press of an arrow key, metres. */
function stepOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, large: boolean): number {
	return Math.max(0.01, onStep(NUDGE * sizeOf(lay, specimen) * (large ? 10 : 1)));
}

/** The larger of a boundary's height and half its width, metres. */
export function sizeOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): number {
	const { halfWidth, low, high } = lay.box(specimen);
	return Math.max(halfWidth, high - low);
}
