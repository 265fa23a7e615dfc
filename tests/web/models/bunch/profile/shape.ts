/** Profiles and parameters for the tests of this room. */
import fc from "fast-check";
import { NUMBER_KEYS, PARAMETERS } from "../../../../../web/src/models/bunch/parameters.generated";
import type { Handle, Shape, ShapeKey } from "../../../../../web/src/models/bunch/profile/handles";
import { HANDLES, handleKeys } from "../../../../../web/src/models/bunch/profile/handles";
import type { Specimen } from "../../../../../web/src/specimen/specimen";

export const SHAPE_KEYS: ShapeKey[] = HANDLES.flatMap(handleKeys);

export const RANGES = new Map(PARAMETERS.map(({ key, min, max }) => [key as string, { min: min ?? 0, max: max ?? 0 }]));

/** Every parameter at its default: long conical. */
export const DEFAULTS = Object.fromEntries(
	PARAMETERS.filter(({ key }) => (NUMBER_KEYS as readonly string[]).includes(key)).map((info) => [
		info.key,
		Number(info.default),
	]),
) as Specimen["parameters"];

/** Any profile of whole pixels within the table's ranges. */
export const anyShape: fc.Arbitrary<Shape> = fc.record(
	Object.fromEntries(SHAPE_KEYS.map((key) => [key, fc.integer(RANGES.get(key))])) as Record<
		ShapeKey,
		fc.Arbitrary<number>
	>,
);

export const anyHandle: fc.Arbitrary<Handle> = fc.constantFrom(...HANDLES);
