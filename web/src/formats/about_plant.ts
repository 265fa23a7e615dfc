import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";
import { writtenSpecimen } from "../specimen/written";
import type { About, PointLabels } from "./about";
import { measuresOf } from "./measures";

/** The part of a model that files with meshes need. */
export interface DescribedModel<S extends Specimen, G extends Plant> extends ModelSchema<S> {
	/** Labels of points on its plants. */
	readonly labels?: PointLabels;
	/** Properties of the plant in such files, besides those of every plant. */
	extras?(grown: G, specimen: S): Record<string, unknown>;
}

/**
 * Returns the origin of a file: enough to grow the plant again and to check that it is the same.
 * @param link the address that restores the specimen; without it the query and fragment alone, `?v=2&…`
 */
export async function aboutPlant<S extends Specimen, G extends Plant>(
	model: DescribedModel<S, G>,
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
