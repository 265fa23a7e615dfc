/** A plant at the ages of its life, for files that show growth. */
import type { Aged } from "../../formats/growth_glb";
import type { Model } from "../../models/model";
import type { Plant } from "../../plant/plant";
import { restore } from "../../specimen/restore";
import type { Specimen } from "../../specimen/specimen";
import type { NumberEntry } from "../../specimen/table";

/**
 * The parameter of age, its value for a grown-up plant where the table has no other, and the number of even steps to
 * show.
 */
const AGE = "age";
const STEPS = 24;

/** Returns the entry of a specimen's age; undefined where it has none, or the plant does not depend on it. */
export function ageOf({ table, ages }: Pick<Model, "table" | "ages">, specimen: Specimen): NumberEntry | undefined {
	const entry = table.entry(AGE);
	if (!entry || entry.kind === "colour" || entry.kind === "choice") return undefined;
	return table.isActive(specimen, entry) && (ages?.(specimen) ?? true) ? entry : undefined;
}

/** Returns whether a specimen has ages; some models know that only after `prepare`. */
export function hasAges(model: Pick<Model, "table" | "ages">, specimen: Specimen): boolean {
	return ageOf(model, specimen) !== undefined;
}

/**
 * Returns the plant from its beginning until it is grown up; undefined where it has no ages.
 * @param grow grows a specimen with its meshes
 */
export function agedOf(
	model: Model,
	specimen: Specimen,
	grow: (specimen: Specimen) => Promise<Plant>,
): Aged | undefined {
	const entry = ageOf(model, specimen);
	if (!entry) return undefined;
	const life = entry.default - entry.min;
	const ages = Array.from({ length: STEPS + 1 }, (_, i) => Math.round(100 * (entry.min + (life * i) / STEPS)) / 100);
	const at = async (age: number) => {
		const { specimen: younger } = restore(model, { [AGE]: age }, specimen);
		return model.parts(await grow(younger), younger);
	};
	return { ages, at };
}
