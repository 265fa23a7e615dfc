/** Targets as grips: where trunks stand, or roots begin. */
import type { Change } from "../../../../controls/desk";
import type { Point } from "../../../../controls/handles/point";
import { onStep } from "../../../../specimen/table";
import type { BoundedSpecimen } from "../bounded";
import { type Facing, moved, placeInWords, seen } from "./facing";
import type { Grip } from "./grip";
import type { Lay } from "./lay";

const WIDTH = 3;
const NAME = "target";

export function targetsIn<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): readonly number[] {
	return specimen.targets ?? lay.targets(specimen);
}

/** x, y and z of each. */
export function feetOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): number[][] {
	const targets = targetsIn(lay, specimen);
	return Array.from({ length: targets.length / WIDTH }, (_, i) => targets.slice(WIDTH * i, WIDTH * (i + 1)));
}

export function footGrips<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, facing: Facing): Grip[] {
	return feetOf(lay, specimen).map((foot, i) => ({
		id: `${NAME}${i}`,
		at: seen(foot, facing),
		label: `${lay.target} ${i + 1}`,
		value: placeInWords(foot, facing),
	}));
}

/** The number of a target's grip; undefined of another. */
export function footIn(id: string): number | undefined {
	return id.startsWith(NAME) ? Number(id.slice(NAME.length)) : undefined;
}

export function pullFoot<S extends BoundedSpecimen>(
	lay: Lay<S>,
	specimen: S,
	index: number,
	to: Point,
	facing: Facing,
): Change {
	const feet = feetOf(lay, specimen);
	feet[index] = moved(feet[index], to, facing).map((value) => onStep(value));
	return { details: { targets: feet.flat() } };
}

/** Back to where the preset, or else the table, has it; all of them so, and no list of them is kept. */
export function resetFoot<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S, index: number): Change {
	const [feet, before] = [feetOf(lay, specimen), feetOf(lay, { ...specimen, targets: preset.targets })];
	feet[index] = before[index] ?? feet[index];
	const same =
		feet.length === before.length && feet.flat().every((value, i) => onStep(before.flat()[i]) === onStep(value));
	return { details: { targets: same ? preset.targets : feet.flat() } };
}

/** The last one stays. */
export function withoutFoot<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, index: number): Change | undefined {
	const feet = feetOf(lay, specimen);
	return feet.length > 1 ? { details: { targets: feet.filter((_, i) => i !== index).flat() } } : undefined;
}
