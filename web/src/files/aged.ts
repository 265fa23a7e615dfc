/** A plant at the ages of its life, for files that show it growing. */
import type { Aged } from "../export/growth_glb";
import type { Model } from "../models/model";
import type { Plant } from "../plant/plant";
import { restore } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";
import type { NumberEntry } from "../specimen/table";

/** The parameter that a life runs by, and how many even steps are shown of it, to where it is grown up. */
const AGE = "age";
const STEPS = 24;
const GROWN_UP = 100;

/** The parameter that is a specimen's age; undefined where it has none. */
export function ageOf({ table }: Pick<Model, "table">, specimen: Specimen): NumberEntry | undefined {
	const entry = table.entry(AGE);
	if (!entry || entry.kind === "colour" || entry.kind === "choice") return undefined;
	return table.heeds(specimen, entry) ? entry : undefined;
}

/** Whether a specimen has ages. */
export function hasAges(model: Pick<Model, "table">, specimen: Specimen): boolean {
	return ageOf(model, specimen) !== undefined;
}

/**
 * The plant from its beginning until it is grown up; undefined where it has no ages.
 * @param grow grows a specimen with its meshes
 */
export function agedOf(
	model: Model,
	specimen: Specimen,
	grow: (specimen: Specimen) => Promise<Plant>,
): Aged | undefined {
	if (!hasAges(model, specimen)) return undefined;
	const ages = Array.from({ length: STEPS + 1 }, (_, i) => Math.round((100 * GROWN_UP * i) / STEPS) / 100);
	const at = async (age: number) => {
		const { specimen: younger } = restore(model, { [AGE]: age }, specimen);
		return model.parts(await grow(younger), younger);
	};
	return { ages, at };
}
