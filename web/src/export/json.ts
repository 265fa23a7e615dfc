/**
 * Any plant → the JSON document: its parts as numbers, for those who compute. Lengths are metres; each number is the
 * shortest decimal that reads back as the same float32, so the fingerprint can be computed again from the document
 * (docs/fingerprint.md).
 */
import type { Organs, Plant, Segments } from "../plant/plant";
import type { Species } from "../specimen/species";
import type { Specimen } from "../specimen/specimen";
import { type WrittenSpecimen, writtenSpecimen } from "../specimen/written";
import { measuresOf, type WrittenMeasures } from "./measures";
import { shortFloat } from "./numbers";

/** What every plant's document has; the rest is its model's. */
export interface PlantDocument<S extends Specimen> {
	specimen: WrittenSpecimen<S>;
	counts: Plant["counts"];
	/** By key; null where one does not apply. Absent where they were not asked for. */
	measures?: WrittenMeasures;
	notes: string[];
	fingerprint: string;
	timings: Plant["timings"];
}

/** A model as far as documents go. */
export interface Recorded<S extends Specimen, G extends Plant, R extends object> extends Species<S> {
	/** The plant as numbers, in the model's own words; segments and organs where it has none. */
	record?(grown: G, specimen: S): R;
}

/** The document; `grown` and `specimen` are only read. Needs no meshes. */
export function exportJson<S extends Specimen, G extends Plant, R extends object>(
	model: Recorded<S, G, R>,
	grown: G,
	specimen: S,
): PlantDocument<S> & R {
	const { counts, notes, fingerprint, timings } = grown;
	return {
		specimen: writtenSpecimen(model, specimen),
		counts,
		...measuresOf(model.table, grown),
		...(model.record?.(grown, specimen) ?? (plantRecord(grown) as unknown as R)),
		notes,
		fingerprint,
		timings,
	};
}

/** A plant of whose parts nothing more is known: what was drawn, and what is borne. */
function plantRecord({ segments, organs }: Plant): object {
	return {
		segments: Array.from({ length: segments.count }, (_, index) => segmentRecord(segments, index)),
		organs: Array.from({ length: organs.count }, (_, index) => organRecord(organs, index)),
	};
}

function segmentRecord({ parent, tag, tags, ends, radii }: Segments, index: number): object {
	const [ax, ay, az, bx, by, bz] = Array.from(ends.subarray(6 * index, 6 * index + 6), shortFloat);
	return {
		parent: parent[index],
		tag: tags[tag[index]],
		start: [ax, ay, az],
		end: [bx, by, bz],
		radius: shortFloat(radii[2 * index]),
		radiusEnd: shortFloat(radii[2 * index + 1]),
	};
}

function organRecord({ segment, tag, tags, transforms }: Organs, index: number): object {
	const [x, y, z, qx, qy, qz, qw, scale] = Array.from(transforms.subarray(8 * index, 8 * index + 8), shortFloat);
	return { segment: segment[index], tag: tags[tag[index]], position: [x, y, z], rotation: [qx, qy, qz, qw], scale };
}
