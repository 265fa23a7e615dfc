/**
 * Grown → the JSON document: every berry and internode with its place, size and parent, for those who compute. Lengths
 * are metres; each number is the shortest decimal that reads back as the same float32, so the fingerprint can be
 * computed again from the document (docs/fingerprint.md).
 */
import {
	type BerryForm,
	type Counts,
	type Grown,
	INTERNODE_KINDS,
	INTERNODE_STATES,
	type InternodeKind,
	type InternodeState,
	type Internodes,
	type Plan,
	type Procedure,
	type Thinned,
	type Trait,
} from "../models/bunch/grown";
import { traitOf } from "../models/bunch/traits";
import { measuresOf, type WrittenMeasures } from "../models/bunch/written_measures";
import type { Specimen } from "../specimen/specimen";
import { type WrittenSpecimen, writtenSpecimen } from "../specimen/written";
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

/** Traits that the document names by themselves, in this order; `width` and `length` come before the direction. */
const STATES = ["exposure", "turned", "opened", "set", "shrivel", "seeds"] as const satisfies readonly Trait[];

/** A berry of the natural procedure; lengths in metres, what they mean is in docs/export.md. */
export interface NaturalBerryRecord extends BerryRecord, Record<(typeof STATES)[number], number> {
	id: number;
	width: number;
	length: number;
	/** Unit vector from the pedicel towards the tip scar. */
	direction: Point;
}

/** A berry that is not there. */
export interface ThinnedRecord {
	id: number;
	why: Thinned["why"];
	/** Where its pedicel begins. */
	x: number;
	y: number;
	z: number;
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
	specimen: WrittenSpecimen;
	procedure: Procedure;
	form: BerryForm;
	plan: Plan & { second?: Plan };
	counts: Counts;
	/** By key; null where one does not apply. Absent where they were not asked for. */
	measures?: WrittenMeasures;
	/** Of the natural procedure `NaturalBerryRecord`. */
	berries: (BerryRecord | NaturalBerryRecord)[];
	thinned: ThinnedRecord[];
	internodes: InternodeRecord[];
	notes: string[];
	fingerprint: string;
	timings: Grown["timings"];
}

/** The document; `grown` and `specimen` are only read. Needs no meshes. */
export function exportJson(grown: Grown, specimen: Specimen): GrownDocument {
	const { procedure, form, counts, berries, thinned, internodes, notes, fingerprint, timings } = grown;
	const berry = procedure === "natural" ? naturalBerryRecord : berryRecord;
	return {
		specimen: writtenSpecimen(specimen),
		procedure,
		form: { ...form, taper: shortFloat(form.taper), blunt: shortFloat(form.blunt) },
		plan: grown.second ? { ...grown.plan, second: grown.second } : { ...grown.plan },
		counts,
		...measuresOf(grown),
		berries: Array.from({ length: berries.count }, (_, index) => berry(grown, index)),
		thinned: thinned.map(({ id, why, place }) => {
			const [x, y, z] = place.map(shortFloat);
			return { id, why, x, y, z };
		}),
		internodes: Array.from({ length: internodes.count }, (_, index) => internodeRecord(internodes, index)),
		notes,
		fingerprint,
		timings,
	};
}

function berryRecord({ berries: { spheres, parent } }: Grown, index: number): BerryRecord {
	const float = (offset: number) => shortFloat(spheres[4 * index + offset]);
	return { x: float(0), y: float(1), z: float(2), r: float(3), parent: parent[index] };
}

function naturalBerryRecord(grown: Grown, index: number): NaturalBerryRecord {
	const { berries } = grown;
	const trait = (name: Trait) => shortFloat(traitOf(berries, index, name));
	const [x, y, z] = Array.from(berries.directions.subarray(3 * index, 3 * index + 3), shortFloat);
	return {
		...berryRecord(grown, index),
		id: berries.ids[index],
		width: trait("width"),
		length: trait("length"),
		direction: [x, y, z],
		...(Object.fromEntries(STATES.map((name) => [name, trait(name)])) as Record<(typeof STATES)[number], number>),
	};
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
