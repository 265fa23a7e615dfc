/** An element's document and plant, and the details of its events. */
import { measuresOf, type WrittenMeasures } from "../formats/measures";
import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import type { Restored } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";

/** The detail of the event `grown`, and the result of `grow()`. */
export interface GrownDetail {
	/** Query and fragment of the link to the specimen. */
	readonly link: string;
	/** A short description: "14 cm long, with 118 berries". */
	readonly words: string;
	/** Numbers of parts, by name. */
	readonly counts: Plant["counts"];
	/** Measures by key; null if a measure does not apply. */
	readonly measures: WrittenMeasures;
	/** Notes about attributes that could not be used, and notes of the core. */
	readonly notes: readonly string[];
	/** Hash over segments and organs, 16 hexadecimal digits: equal plants have equal fingerprints. */
	readonly fingerprint: string;
}

export interface SpecimenDocument {
	readonly model: PageModel;
	readonly specimen: Specimen;
	readonly notes: readonly string[];
}

/** A document with its plant. */
export interface GrownDocument extends SpecimenDocument {
	readonly grown: Plant;
}

/** Returns the document of a restored specimen, with the texts of its notes. */
export const documentFrom = (model: PageModel, { specimen, notes }: Restored): SpecimenDocument => ({
	model,
	specimen,
	notes: notes.map(({ text }) => text),
});

/**
 * Returns the document with its specimen changed; unchanged if the change belongs to another model, which the page has
 * since replaced.
 */
export function changedIn(
	{ specimen, ...rest }: SpecimenDocument,
	change: (specimen: Specimen) => Specimen,
): SpecimenDocument {
	const next = change(specimen);
	return { ...rest, specimen: next.model === specimen.model ? next : specimen };
}

/** Collects the details of the `grown` event. */
export async function detailOf({ model, specimen, grown, notes }: GrownDocument): Promise<GrownDetail> {
	return {
		link: await encodeLink(model, specimen),
		words: model.summary(grown, specimen),
		counts: grown.counts,
		measures: measuresOf(model.table, grown).measures ?? {},
		notes: [...notes, ...grown.notes],
		fingerprint: grown.fingerprint,
	};
}
