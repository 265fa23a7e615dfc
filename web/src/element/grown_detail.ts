/** What an element shows, and what it tells of it. */
import { measuresOf, type WrittenMeasures } from "../export/measures";
import type { Model } from "../models/model";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import type { Specimen } from "../specimen/specimen";

/** What `grown` and `grow()` tell. */
export interface GrownDetail {
	/** Query and fragment that bring the specimen back. */
	readonly link: string;
	/** In a few plain words: "118 berries, 14 cm long". */
	readonly words: string;
	readonly counts: Plant["counts"];
	readonly measures: WrittenMeasures;
	readonly notes: readonly string[];
	readonly fingerprint: string;
}

export interface Document {
	readonly model: Model;
	readonly specimen: Specimen;
	readonly notes: readonly string[];
}

/** A plant that grew. */
export interface Shown extends Document {
	readonly grown: Plant;
}

export async function detailOf({ model, specimen, grown, notes }: Shown): Promise<GrownDetail> {
	return {
		link: await encodeLink(model, specimen),
		words: model.words(grown, specimen),
		counts: grown.counts,
		measures: measuresOf(model.table, grown).measures ?? {},
		notes: [...notes, ...grown.notes],
		fingerprint: grown.fingerprint,
	};
}
