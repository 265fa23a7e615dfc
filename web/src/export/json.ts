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

/** A place in metres, +Y up. */
export type Vector = [x: number, y: number, z: number];

/** A drawn module. */
export interface SegmentRecord {
	/** Index of the segment it grows from, which comes earlier; −1 at a root. */
	parent: number;
	/** By the model's own names. */
	kind: string;
	/** Where it begins. */
	start: Vector;
	/** Where it ends. */
	end: Vector;
	/** At the start, metres. */
	radius: number;
	/** At the end, metres. */
	radiusEnd: number;
}

/** Something borne. */
export interface OrganRecord {
	/** By the model's own names. */
	kind: string;
	/** Index of the segment that bears it; −1 for none. */
	segment: number;
	/** Where it is held. */
	position: Vector;
	/** Unit quaternion x y z w. */
	rotation: [x: number, y: number, z: number, w: number];
	/** How many metres one unit of its mesh is. */
	scale: number;
}

/** What every plant's document has; the rest is its model's. */
export interface PlantDocument<S extends Specimen> {
	specimen: WrittenSpecimen<S>;
	counts: Plant["counts"];
	/** By key; null where one does not apply; none where the model measures nothing or nothing was asked for. */
	measures: WrittenMeasures;
	/** One a drawn module, unmerged, parents first; absent where nothing was drawn. */
	segments?: SegmentRecord[];
	/** Absent where nothing is borne. */
	organs?: OrganRecord[];
	notes: string[];
	fingerprint: string;
	timings: Plant["timings"];
}

/** A model as far as documents go. */
export interface Recorded<S extends Specimen, G extends Plant, R extends object> extends Species<S> {
	/** What the document has of the plant besides, or in place of, what it has of every plant. */
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
		measures: {},
		...measuresOf(model.table, grown),
		...plantRecord(grown),
		...(model.record?.(grown, specimen) as R),
		notes,
		fingerprint,
		timings,
	};
}

/** What was drawn, and what is borne. */
function plantRecord({ segments, organs }: Plant): Pick<PlantDocument<Specimen>, "segments" | "organs"> {
	const each = <Row>(count: number, row: (index: number) => Row) => Array.from({ length: count }, (_, i) => row(i));
	return {
		...(segments.count > 0 ? { segments: each(segments.count, (index) => segmentRecord(segments, index)) } : {}),
		...(organs.count > 0 ? { organs: each(organs.count, (index) => organRecord(organs, index)) } : {}),
	};
}

function segmentRecord({ parent, tag, tags, ends, radii }: Segments, index: number): SegmentRecord {
	const [ax, ay, az, bx, by, bz] = Array.from(ends.subarray(6 * index, 6 * index + 6), shortFloat);
	return {
		parent: parent[index],
		kind: tags[tag[index]],
		start: [ax, ay, az],
		end: [bx, by, bz],
		radius: shortFloat(radii[2 * index]),
		radiusEnd: shortFloat(radii[2 * index + 1]),
	};
}

function organRecord({ segment, tag, tags, transforms }: Organs, index: number): OrganRecord {
	const [x, y, z, qx, qy, qz, qw, scale] = Array.from(transforms.subarray(8 * index, 8 * index + 8), shortFloat);
	return { kind: tags[tag[index]], segment: segment[index], position: [x, y, z], rotation: [qx, qy, qz, qw], scale };
}
