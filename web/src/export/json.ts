/**
 * Grown → the JSON document: every berry and internode with its place, size and parent, for those who compute. Lengths
 * are metres; each number is the shortest decimal that reads back as the same float32, so the fingerprint can be
 * computed again from the document (docs/fingerprint.md).
 */
import {
	type Berries,
	type Counts,
	type Grown,
	INTERNODE_KINDS,
	INTERNODE_STATES,
	type InternodeKind,
	type InternodeState,
	type Internodes,
	type Plan,
} from "../core/grown";
import type { Specimen } from "../specimen/specimen";
import { shortFloat } from "./numbers";

export type Point = [x: number, y: number, z: number];

export interface BerryRecord {
	x: number;
	y: number;
	z: number;
	r: number;
	/** Index of its pedicel among `internodes`. */
	parent: number;
}

export interface InternodeRecord {
	/** Index of the internode it grows from, which comes earlier; −1 at the root. */
	parent: number;
	kind: InternodeKind;
	/** First-order axis s, 0 at the top; −1 for the rachis. */
	axis: number;
	start: Point;
	end: Point;
	/** At the start. */
	radius: number;
	radiusEnd: number;
	state: InternodeState;
}

export interface GrownDocument {
	specimen: Specimen;
	plan: Plan & { second?: Plan };
	counts: Counts;
	berries: BerryRecord[];
	internodes: InternodeRecord[];
	notes: string[];
	fingerprint: string;
	timings: Grown["timings"];
}

/** The document; `grown` and `specimen` are only read. Needs no meshes. */
export function exportJson(grown: Grown, specimen: Specimen): GrownDocument {
	return {
		specimen,
		plan: grown.second ? { ...grown.plan, second: grown.second } : { ...grown.plan },
		counts: grown.counts,
		berries: Array.from({ length: grown.berries.count }, (_, index) => berryRecord(grown.berries, index)),
		internodes: Array.from({ length: grown.internodes.count }, (_, index) => internodeRecord(grown.internodes, index)),
		notes: grown.notes,
		fingerprint: grown.fingerprint,
		timings: grown.timings,
	};
}

function berryRecord({ spheres, parent }: Berries, index: number): BerryRecord {
	const float = (offset: number) => shortFloat(spheres[4 * index + offset]);
	return { x: float(0), y: float(1), z: float(2), r: float(3), parent: parent[index] };
}

function internodeRecord({ parent, kind, axis, state, ends, radii }: Internodes, index: number): InternodeRecord {
	const end = (offset: number) => shortFloat(ends[6 * index + offset]);
	return {
		parent: parent[index],
		kind: INTERNODE_KINDS[kind[index]] as InternodeKind,
		axis: axis[index],
		start: [end(0), end(1), end(2)],
		end: [end(3), end(4), end(5)],
		radius: shortFloat(radii[2 * index]),
		radiusEnd: shortFloat(radii[2 * index + 1]),
		state: INTERNODE_STATES[state[index]] as InternodeState,
	};
}
