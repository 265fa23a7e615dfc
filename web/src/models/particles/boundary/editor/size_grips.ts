/** The ends and the side of a boundary's box as grips. */

import { lengthInWords } from "../../../../plant/in_words";
import type { Change } from "../../../../ui/editor_context";
import type { BoundedSpecimen } from "../bounded";
import { axisOf, type Box, type Lay, LEAST } from "./lay";
import type { Unstepped } from "./stepped";

type End = "low" | "high";

export function sizeGrips<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S): Unstepped[] {
	return [
		endGrip(lay, specimen, preset, "high"),
		sideGrip(lay, specimen, preset),
		endGrip(lay, specimen, preset, "low"),
	];
}

function endGrip<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S, end: End): Unstepped {
	const y = lay.box(specimen)[end];
	return {
		id: end,
		at: { x: axisOf(lay, specimen), y },
		label: lay.ends[end],
		value: heightInWords(y),
		pull: (to) => withEnd(lay, specimen, end, to.y),
		reset: () => withPresetsEnd(lay, specimen, preset, end),
	};
}

/** At the height at which the boundary is widest. */
export function sideGrip<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S): Unstepped {
	const box = lay.box(specimen);
	const axis = axisOf(lay, specimen);
	const sized = (halfWidth: number): Change => ({ parameters: lay.fit(specimen, { ...box, halfWidth }) });
	return {
		id: "side",
		at: { x: axis + box.halfWidth, y: box.low + shoulderOf(lay, specimen) * (box.high - box.low) },
		label: "Width",
		value: `${lengthInWords(2 * box.halfWidth)} wide`,
		pull: (to) => sized(Math.max(LEAST / 2, Math.abs(to.x - axis))),
		reset: () => sized(lay.box(preset).halfWidth),
	};
}

/** One end of the box at a height; the other stays. */
export function withEnd<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, end: End, y: number): Change {
	const box = lay.box(specimen);
	const at = end === "high" ? Math.max(y, box.low + LEAST) : Math.min(y, box.high - LEAST);
	return { parameters: lay.fit(specimen, { ...box, [end]: at }) };
}

/** One end as in the preset: at the ground where that has it, away from it as far from the other as there. */
export function withPresetsEnd<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S, end: End): Change {
	const [box, before] = [lay.box(specimen), lay.box(preset)];
	const near: End = atGround(before);
	return withEnd(lay, specimen, end, end === near ? before[near] : box[near] + before[end] - before[near]);
}

const atGround = ({ high }: Box): End => (high > 0 ? "low" : "high");

export function heightInWords(height: number): string {
	return `${lengthInWords(Math.abs(height))} ${height < 0 ? "below ground" : "up"}`;
}

/** The height at which a boundary is widest, as a share. */
function shoulderOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): number {
	const form = lay.form(specimen);
	return form === "cone" ? 0 : form === "bowl" || form === "coneDown" ? 1 : 0.5;
}
