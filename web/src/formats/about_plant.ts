import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";
import { writtenSpecimen } from "../specimen/written";
import type { About, PointLabels } from "./about";
import { measuresOf } from "./measures";

/** A model as far as files with meshes go. */
export interface Described<S extends Specimen, G extends Plant> extends ModelSchema<S> {
	/** How points on its plants are labelled. */
	readonly labels?: PointLabels;
	/** What such files say of the plant besides what they say of every plant. */
	extras?(grown: G, specimen: S): Record<string, unknown>;
}

/**
 * Where a file came from: enough to grow the plant again and to check that it is the same.
 * @param link the address that brings the specimen back; without it the query and fragment alone, `?v=2&…`
 */
export async function aboutPlant<S extends Specimen, G extends Plant>(
	model: Described<S, G>,
	grown: G,
	specimen: S,
	link?: string,
): Promise<About> {
	const kind = model.name.charAt(0).toUpperCase() + model.name.slice(1);
	return {
		name: `${kind} ${specimen.preset}`,
		link: link ?? (await encodeLink(model, specimen)),
		...(model.labels && { labels: model.labels }),
		extras: {
			specimen: writtenSpecimen(model, specimen),
			...model.extras?.(grown, specimen),
			counts: grown.counts,
			...measuresOf(model.table, grown),
			fingerprint: grown.fingerprint,
		},
	};
}
