/** Grips of the targets: the bases of trunks, or the collars of roots. */

import { onStep } from "../../../../specimen/table";
import type { Change } from "../../../../ui/editor_context";
import { text } from "../../messages.generated";
import type { BoundedSpecimen } from "../bounded";
import { fitted, MAX_TARGETS } from "../details/places";
import type { GripWithoutKeys } from "./arrow_keys";
import type { BoundaryLayout } from "./boundary_layout";
import { type Facing, moved, placeInWords, seen } from "./facing";

const WIDTH = 3;

/** Returns x, y and z of each target: those set by hand, or else those of the layout. */
export function targetsIn<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): number[][] {
	const targets = specimen.targets ?? layout.targets(specimen);
	return Array.from({ length: targets.length / WIDTH }, (_, i) => targets.slice(WIDTH * i, WIDTH * (i + 1)));
}

/** Returns the grips of all targets; none where a list cannot hold that many. The last target cannot be removed. */
export function targetGrips<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
	facing: Facing,
): GripWithoutKeys[] {
	const targets = targetsIn(layout, specimen);
	if (targets.length > MAX_TARGETS) return [];
	return targets.map((target, i) => ({
		id: `target${i}`,
		at: seen(target, facing),
		label: text("target", { kind: layout.target, number: i + 1 }),
		value: placeInWords(target, facing),
		pull: (to) => changeTo(targets.toSpliced(i, 1, moved(target, to, facing))),
		reset: () => changeToPresetTarget(layout, specimen, preset, i),
		...(targets.length > 1 ? { remove: () => changeTo(targets.toSpliced(i, 1)) } : {}),
	}));
}

/** Returns the change that sets all targets. */
const changeTo = (targets: readonly (readonly number[])[]): Change => ({
	details: { targets: fitted("targets", targets) },
});

/**
 * Returns the change that resets one target to the preset's or the table's position; where all targets are reset, the
 * list is removed.
 */
function changeToPresetTarget<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	preset: S,
	index: number,
): Change {
	const [feet, before] = [targetsIn(layout, specimen), targetsIn(layout, { ...specimen, targets: preset.targets })];
	feet[index] = before[index] ?? feet[index];
	const same =
		feet.length === before.length && feet.flat().every((value, i) => onStep(before.flat()[i]) === onStep(value));
	return same ? { details: { targets: preset.targets } } : changeTo(feet);
}
