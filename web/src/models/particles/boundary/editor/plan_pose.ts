/** The grips of a plan: the boundary, its obstacles and its targets from above. Pure functions from a specimen to a change of it. */
import type { Change } from "../../../../controls/desk";
import type { Point } from "../../../../controls/handles/point";
import type { BoundedSpecimen } from "../bounded";
import { lengthInWords } from "../words";
import { LEAST, stepOf } from "./boundary_pose";
import { FROM_ABOVE } from "./facing";
import { footGrips, footIn, pullFoot, resetFoot, withoutFoot } from "./feet";
import type { Grip, Pose } from "./grip";
import type { Lay } from "./lay";
import { isWall, pullWall, wallGrips } from "./walls";

export function planPose<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S): Pose {
	const { parameters, obstacles, rounds, targets } = specimen;
	const own = sizeGrips(lay, specimen);
	const grips = [...own, ...wallGrips(specimen, FROM_ABOVE), ...footGrips(lay, specimen, FROM_ABOVE)];
	const pull = (id: string, to: Point): Change => {
		const foot = footIn(id);
		if (foot !== undefined) return pullFoot(lay, specimen, foot, to, FROM_ABOVE);
		return isWall(id) ? pullWall(specimen, id, to, FROM_ABOVE) : sized(lay, specimen, id, to);
	};
	return {
		grips,
		change: { parameters, details: { obstacles, rounds, targets } },
		pull,
		nudge: (id, right, up, large) => {
			const grip = grips.find((each) => each.id === id);
			const step = stepOf(lay, specimen, large);
			return grip && pull(id, { x: grip.at.x + right * step, y: grip.at.y + up * step });
		},
		reset: (id) => {
			const foot = footIn(id);
			if (foot !== undefined) return resetFoot(lay, specimen, preset, foot);
			const before = sizeGrips(lay, preset).find((grip) => grip.id === id);
			return before && sized(lay, specimen, id, before.at);
		},
		remove: (id) => {
			const foot = footIn(id);
			return foot === undefined ? undefined : withoutFoot(lay, specimen, foot);
		},
	};
}

function sizeGrips<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): Grip[] {
	const axis = lay.axes(specimen).at(-1) ?? 0;
	const [wide, deep] = [lay.box(specimen).halfWidth, lay.halfDepth(specimen)];
	return [
		{ id: "side", at: { x: axis + wide, y: 0 }, label: "Width", value: `${lengthInWords(2 * wide)} wide` },
		{ id: "front", at: { x: axis, y: -deep }, label: "Depth", value: `${lengthInWords(2 * deep)} front to back` },
	];
}

function sized<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, id: string, to: Point): Change {
	if (id === "front") return { parameters: lay.deepen(specimen, Math.max(LEAST / 2, -to.y)) };
	const halfWidth = Math.max(LEAST / 2, to.x - (lay.axes(specimen).at(-1) ?? 0));
	return { parameters: lay.fit(specimen, { ...lay.box(specimen), halfWidth }) };
}
