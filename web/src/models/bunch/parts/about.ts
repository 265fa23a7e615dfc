import type { About } from "../../../export/about";
import { encodeLink } from "../../../specimen/link";
import type { Specimen } from "../../../specimen/specimen";
import { writtenSpecimen } from "../../../specimen/written";
import type { Grown } from "../grown";
import { measuresOf } from "../written_measures";
import { plantName } from "./names";

/**
 * Where a file came from: enough to grow it again and to check that it is the same.
 * @param link the address that brings the specimen back; without it the query alone, `?v=2&…`
 */
export async function aboutBunch(grown: Grown, specimen: Specimen, link?: string): Promise<About> {
	const { procedure, plan, second, counts, fingerprint } = grown;
	return {
		name: plantName(specimen),
		link: link ?? (await encodeLink(specimen)),
		extras: {
			specimen: writtenSpecimen(specimen),
			procedure,
			plan: { ...plan, second },
			counts,
			...measuresOf(grown),
			fingerprint,
		},
	};
}
