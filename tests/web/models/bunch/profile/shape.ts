/** Profiles and parameters for the tests in this folder. */

import fc from "fast-check";
import type { BunchShape, Handle, ShapeKey } from "../../../../../web/src/models/bunch/profile/handles";
import { HANDLES, handleKeys } from "../../../../../web/src/models/bunch/profile/handles";
import type { Specimen } from "../../../bunch";
import { CORE_ENTRIES } from "../../../bunch";

export const SHAPE_KEYS: ShapeKey[] = HANDLES.flatMap(handleKeys);

export const RANGES = new Map(CORE_ENTRIES.map(({ key, min, max }) => [key, { min, max }]));

/** Every parameter at its default: long conical. */
export const DEFAULTS = Object.fromEntries(
	CORE_ENTRIES.map((entry) => [entry.key, entry.default]),
) as Specimen["parameters"];

/** Any profile of whole pixels within the table's ranges. */
export const anyShape: fc.Arbitrary<BunchShape> = fc.record(
	Object.fromEntries(SHAPE_KEYS.map((key) => [key, fc.integer(RANGES.get(key))])) as Record<
		ShapeKey,
		fc.Arbitrary<number>
	>,
);

export const anyHandle: fc.Arbitrary<Handle> = fc.constantFrom(...HANDLES);
