/** What an element shows, and what it tells of it. */
import { measuresOf, type WrittenMeasures } from "../formats/measures";
import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import type { Restored } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";

/** What `grown` and `grow()` tell. */
export interface GrownDetail {
	/** Query and fragment that bring the specimen back. */
	readonly link: string;
	/** In a few plain words: "118 berries, 14 cm long". */
	readonly words: string;
	/** How many of what there are, by name. */
	readonly counts: Plant["counts"];
	/** By key; null where one does not apply. */
	readonly measures: WrittenMeasures;
	/** What of the attributes could not be used, and what the core had to say. */
	readonly notes: readonly string[];
	/** 16 hexadecimal digits over segments and organs: the same plant has the same. */
	readonly fingerprint: string;
}

export interface SpecimenDocument {
	readonly model: PageModel;
	readonly specimen: Specimen;
	readonly notes: readonly string[];
}

/** A plant that grew. */
export interface GrownDocument extends SpecimenDocument {
	readonly grown: Plant;
}

export const documentFrom = (model: PageModel, { specimen, notes }: Restored): SpecimenDocument => ({
	model,
	specimen,
	notes: notes.map(({ text }) => text),
});

/** The document with its specimen changed; as it was where the change is of another model's, which a page has since replaced. */
export function changedIn(
	{ specimen, ...rest }: SpecimenDocument,
	change: (specimen: Specimen) => Specimen,
): SpecimenDocument {
	const next = change(specimen);
	return { ...rest, specimen: next.model === specimen.model ? next : specimen };
}

export async function detailOf({ model, specimen, grown, notes }: GrownDocument): Promise<GrownDetail> {
	return {
		link: await encodeLink(model, specimen),
		words: model.words(grown, specimen),
		counts: grown.counts,
		measures: measuresOf(model.table, grown).measures ?? {},
		notes: [...notes, ...grown.notes],
		fingerprint: grown.fingerprint,
	};
}
