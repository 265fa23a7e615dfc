/** A bunch as numbers: every berry and internode with its place, size and parent, for those who compute. Lengths are metres. */
import { shortFloat } from "../../export/numbers";
import {
	type BerryForm,
	type Grown,
	INTERNODE_KINDS,
	INTERNODE_STATES,
	type InternodeKind,
	type InternodeState,
	type Internodes,
	type OwnProfile,
	type Plan,
	type Procedure,
	type Thinned,
	type Trait,
} from "./grown";
import { traitOf } from "./traits";

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

/** What the JSON document has of a bunch besides what every plant has. */
export interface BunchRecord {
	procedure: Procedure;
	form: BerryForm;
	/** Of the natural procedure: what the bunch fills, in pixels. */
	profile?: OwnProfile;
	/** Of the handles. */
	plan: Plan & { second?: Plan };
	/** Of the natural procedure `NaturalBerryRecord`. */
	berries: (BerryRecord | NaturalBerryRecord)[];
	thinned: ThinnedRecord[];
	internodes: InternodeRecord[];
	/** What pedicels bear, as any plant's organs are listed. */
	organs: BerryOrgan[];
}

/** A berry as an organ among others. */
export interface BerryOrgan {
	kind: "berry" | "flower";
	/** Index of its pedicel among `segments`. */
	segment: number;
	position: Point;
	/** Of the ball of its volume. */
	radius: number;
	/** Unit vector from the pedicel towards the tip scar. */
	direction: Point;
}

/** `grown` is only read. Needs no meshes. */
export function bunchRecord(grown: Grown): BunchRecord {
	const { procedure, form, profile, berries, thinned, internodes } = grown;
	const berry = procedure === "natural" ? naturalBerryRecord : berryRecord;
	return {
		procedure,
		form: { ...form, taper: shortFloat(form.taper), blunt: shortFloat(form.blunt), curve: shortFloat(form.curve) },
		...(profile && { profile: shortened(profile) }),
		plan: grown.second ? { ...grown.plan, second: grown.second } : { ...grown.plan },
		berries: Array.from({ length: berries.count }, (_, index) => berry(grown, index)),
		thinned: thinned.map(({ id, why, place }) => {
			const [x, y, z] = place.map(shortFloat);
			return { id, why, x, y, z };
		}),
		internodes: Array.from({ length: internodes.count }, (_, index) => internodeRecord(internodes, index)),
		organs: Array.from({ length: berries.count }, (_, index) => berryOrgan(grown, index)),
	};
}

function shortened(profile: OwnProfile): OwnProfile {
	return Object.fromEntries(Object.entries(profile).map(([key, value]) => [key, shortFloat(value)])) as OwnProfile;
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

function berryOrgan({ berries }: Grown, index: number): BerryOrgan {
	const [x, y, z, radius] = Array.from(berries.spheres.subarray(4 * index, 4 * index + 4), shortFloat);
	const [dx, dy, dz] = Array.from(berries.directions.subarray(3 * index, 3 * index + 3), shortFloat);
	return {
		kind: traitOf(berries, index, "set") > 0 ? "berry" : "flower",
		segment: berries.parent[index],
		position: [x, y, z],
		radius,
		direction: [dx, dy, dz],
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
