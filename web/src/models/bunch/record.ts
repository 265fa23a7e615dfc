/**
 * Record of a bunch in the JSON document: every berry and internode with its position, size and parent. Lengths are
 * metres.
 */
import { shortFloat } from "../../formats/numbers";
import { type CsvRows, floats, integers, recordRows, vectors, words } from "../../formats/rows";
import {
	type Berries,
	type BerryForm,
	type BunchPlant,
	INTERNODE_KINDS,
	INTERNODE_STATES,
	type InternodeKind,
	type InternodeState,
	type Internodes,
	type OwnProfile,
	type Plan,
	type Procedure,
	THINNED_WHY,
	type Thinned,
	TRAITS,
	type Trait,
} from "./bunch_plant";

export type Point3 = [x: number, y: number, z: number];

export interface BerryRecord {
	x: number;
	y: number;
	z: number;
	r: number;
	/** Index of its pedicel in `internodes`. */
	parent: number;
}

/** Traits with fields of their own, in this order; `width` and `length` come before the direction. */
const STATES = ["exposure", "turned", "opened", "set", "shrivel", "seeds"] as const satisfies readonly Trait[];

/** A berry of the natural procedure; lengths in metres; docs/export.md describes the fields. */
export interface NaturalBerryRecord extends BerryRecord, Record<(typeof STATES)[number], number> {
	id: number;
	width: number;
	length: number;
	/** Unit vector from the pedicel towards the tip scar. */
	direction: Point3;
}

/** A missing berry. */
export interface ThinnedRecord {
	id: number;
	why: Thinned["why"];
	/** Position where its pedicel begins. */
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
	start: Point3;
	end: Point3;
	/** Radius at the start. */
	radius: number;
	radiusEnd: number;
	state: InternodeState;
}

/** Fields of a bunch in the JSON document besides those of every plant. */
export interface BunchRecord {
	procedure: Procedure;
	form: BerryForm;
	/** Profile that the bunch fills, in pixels; natural procedure only. */
	profile?: OwnProfile;
	/** Plan of the handles' profile. */
	plan: Plan & { second?: Plan };
	/** Berries, as `NaturalBerryRecord` for the natural procedure. */
	berries: CsvRows<BerryRecord | NaturalBerryRecord>;
	thinned: CsvRows<ThinnedRecord>;
	internodes: CsvRows<InternodeRecord>;
	/** Berries as organs, like any plant's. */
	organs: CsvRows<BerryOrgan>;
}

/** A berry as an organ among others. */
export interface BerryOrgan {
	kind: "berry" | "flower";
	/** Index of its pedicel in `segments`. */
	segment: number;
	position: Point3;
	/** Radius of the ball of its volume. */
	radius: number;
	/** Unit vector from the pedicel towards the tip scar. */
	direction: Point3;
}

/** Returns the record of a bunch; does not modify it and needs no meshes. */
export function bunchRecord(grown: BunchPlant): BunchRecord {
	const { procedure, form, profile, berries, thinned, internodes } = grown;
	return {
		procedure,
		form: { ...form, taper: shortFloat(form.taper), blunt: shortFloat(form.blunt), curve: shortFloat(form.curve) },
		...(profile && { profile: shortenedProfile(profile) }),
		plan: grown.second ? { ...grown.plan, second: grown.second } : { ...grown.plan },
		berries:
			procedure === "natural"
				? naturalBerryRows(berries)
				: recordRows<BerryRecord>(berries.count, ballColumns(berries)),
		thinned: thinnedRows(thinned),
		internodes: internodeRows(internodes),
		organs: organRows(berries),
	};
}

/** Returns a profile whose numbers have as few digits as float32 needs. */
function shortenedProfile(profile: OwnProfile): OwnProfile {
	return Object.fromEntries(Object.entries(profile).map(([key, value]) => [key, shortFloat(value)])) as OwnProfile;
}

/** Columns of every berry record: centre, radius of the ball of its volume, and its pedicel. */
function ballColumns({ spheres, parent }: Berries) {
	return {
		x: floats(spheres, 4, 0),
		y: floats(spheres, 4, 1),
		z: floats(spheres, 4, 2),
		r: floats(spheres, 4, 3),
		parent: integers(parent),
	};
}

/** Returns the berries of a natural bunch as records. */
function naturalBerryRows(berries: Berries): CsvRows<NaturalBerryRecord> {
	const trait = (name: Trait) => floats(berries.traits, TRAITS.length, TRAITS.indexOf(name));
	return recordRows<NaturalBerryRecord>(berries.count, {
		...ballColumns(berries),
		id: integers(berries.ids),
		width: trait("width"),
		length: trait("length"),
		direction: vectors(berries.directions, 3, 0, 3),
		exposure: trait("exposure"),
		turned: trait("turned"),
		opened: trait("opened"),
		set: trait("set"),
		shrivel: trait("shrivel"),
		seeds: trait("seeds"),
	});
}

/** Returns the removed berries as records, with the reason of their removal. */
function thinnedRows(thinned: BunchPlant["thinned"]): CsvRows<ThinnedRecord> {
	const places = new Float32Array(3 * thinned.length);
	thinned.forEach(({ place }, index) => {
		places.set(place, 3 * index);
	});
	return recordRows<ThinnedRecord>(thinned.length, {
		id: integers(thinned.map(({ id }) => id)),
		why: words(
			THINNED_WHY,
			thinned.map(({ why }) => THINNED_WHY.indexOf(why)),
		),
		x: floats(places, 3, 0),
		y: floats(places, 3, 1),
		z: floats(places, 3, 2),
	});
}

/** Returns flowers and berries as records of organs, in the form that all models share; a flower has not set fruit. */
function organRows({ count, spheres, parent, directions, traits }: Berries): CsvRows<BerryOrgan> {
	const set = TRAITS.indexOf("set");
	const isBerry = Uint8Array.from({ length: count }, (_, index) => (traits[TRAITS.length * index + set] > 0 ? 1 : 0));
	return recordRows<BerryOrgan>(count, {
		kind: words(["flower", "berry"], isBerry),
		segment: integers(parent),
		position: vectors(spheres, 4, 0, 3),
		radius: floats(spheres, 4, 3),
		direction: vectors(directions, 3, 0, 3),
	});
}

/** Returns the internodes as records: `ends` has 6 values each (start, end), `radii` 2. */
function internodeRows({ count, parent, kind, axis, state, ends, radii }: Internodes): CsvRows<InternodeRecord> {
	return recordRows<InternodeRecord>(count, {
		parent: integers(parent),
		kind: words(INTERNODE_KINDS, kind),
		axis: integers(axis),
		start: vectors(ends, 6, 0, 3),
		end: vectors(ends, 6, 3, 3),
		radius: floats(radii, 2, 0),
		radiusEnd: floats(radii, 2, 1),
		state: words(INTERNODE_STATES, state),
	});
}
