/** Grips of the targets: the bases of trunks, or the collars of roots. */

import { onStep } from "../../../../specimen/table";
import type { Change } from "../../../../ui/editor_context";
import type { BoundedSpecimen } from "../bounded";
import { fitted, MOST_TARGETS } from "../details/places";
import type { GripWithoutKeys } from "./arrow_keys";
import type { BoundaryLayout } from "./boundary_layout";
import { type Facing, moved, placeInWords, seen } from "./facing";

const WIDTH = 3;

/** x, y and z of each target. */
export function targetsIn<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): number[][] {
	const targets = specimen.targets ?? layout.targets(specimen);
	return Array.from({ length: targets.length / WIDTH }, (_, i) => targets.slice(WIDTH * i, WIDTH * (i + 1)));
}

/** Grips of all targets; none where a list cannot hold that many. The last target cannot be removed. */
export function targetGrips<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
	facing: Facing,
): GripWithoutKeys[] {
	const feet = targetsIn(layout, specimen);
	if (feet.length > MOST_TARGETS) return [];
	return feet.map((foot, i) => ({
		id: `target${i}`,
		at: seen(foot, facing),
		label: `${layout.target} ${i + 1}`,
		value: placeInWords(foot, facing),
		pull: (to) => placed(feet.toSpliced(i, 1, moved(foot, to, facing))),
		reset: () => reset(layout, specimen, preset, i),
		...(feet.length > 1 ? { remove: () => placed(feet.toSpliced(i, 1)) } : {}),
	}));
}

const placed = (feet: readonly (readonly number[])[]): Change => ({ details: { targets: fitted("targets", feet) } });

/** Resets one target to the preset's or the table's position; where all targets are reset, the list is removed. */
function reset<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S, preset: S, index: number): Change {
	const [feet, before] = [targetsIn(layout, specimen), targetsIn(layout, { ...specimen, targets: preset.targets })];
	feet[index] = before[index] ?? feet[index];
	const same =
		feet.length === before.length && feet.flat().every((value, i) => onStep(before.flat()[i]) === onStep(value));
	return same ? { details: { targets: preset.targets } } : placed(feet);
}
