/** The grips of a plan: the boundary, its obstacles and its targets from above. Pure functions from a specimen to a change of it. */
import type { Change } from "../../../../controls/desk";
import type { Point } from "../../../../controls/handles/point";
import type { BoundedSpecimen } from "../bounded";
import { lengthInWords } from "../words";
import { LEAST } from "./boundary_pose";
import { FROM_ABOVE } from "./facing";
import { flatPose } from "./flat_pose";
import type { Grip, Pose } from "./grip";
import type { Lay } from "./lay";

export function planPose<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S): Pose {
	const { parameters, obstacles, rounds, targets } = specimen;
	return flatPose(FROM_ABOVE, lay, specimen, preset, {
		grips: sizeGrips(lay, specimen),
		change: { parameters, details: { obstacles, rounds, targets } },
		pull: (id, to) => sized(lay, specimen, id, to),
		reset: (id) => {
			const before = sizeGrips(lay, preset).find((grip) => grip.id === id);
			return before && sized(lay, specimen, id, before.at);
		},
	});
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
