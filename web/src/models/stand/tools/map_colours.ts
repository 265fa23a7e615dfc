/** The colours of a stand's map: each sort has that of its flowers, or, where it has none, of its leaves, on ground as dark as it takes to tell them. Pure. */
import { type Colour, encoded, fromLch, type Lch, linear, mixed, toLch } from "../../../plant/colour";
import type { Member, MemberMesh } from "../../model";
import { firstAlike } from "../members";
import type { StandPlant } from "../stand_plant";

/** Lightness that ground has at the most and plants at the least: three times the light apart, so that none is lost on it. */
const DARKEST = 0.35;
const LIGHT = 0.63;
const LIGHTEST = 0.97;
/** Two sorts closer than this are taken for one (OKLab); then one is made lighter or darker by steps, or else turned in hue, radians, either way. */
const APART = 0.07;
const STEP = 0.05;
const TURN = 0.5;
/** So many plants of a sort say what it looks like: one may be in bud. */
const ASKED = 8;
/** What is without colour counts so much beside chroma. */
const DULL = 0.01;
const FLOWERS = /petal|flower|blossom|floret|berr/i;
const UNGROWN: Colour = [0.3, 0.32, 0.25];
const COLOUR_STEPS = 65_535;

export function groundColour(soil: string): string {
	const lch = toLch(linear(soil));
	return written(fromLch({ ...lch, lightness: Math.min(DARKEST, lch.lightness) }));
}

/** Of each kind; those that are called the same have one. */
export function kindColours(stand: StandPlant): readonly string[] {
	const first = firstAlike(stand);
	const known = new Map<number, Lch>();
	for (const kind of new Set(first)) {
		const seen = toLch(meanOf(membersOf(stand, first, kind)));
		const lightness = Math.min(LIGHTEST, Math.max(LIGHT, seen.lightness));
		known.set(kind, apartFrom([...known.values()], { ...seen, lightness }));
	}
	return first.map((kind) => written(fromLch(known.get(kind) as Lch)));
}

function membersOf({ places, memberOf, members }: StandPlant, first: readonly number[], kind: number): Member[] {
	const found = new Set<Member>();
	for (let plant = 0; plant < places.count && found.size < ASKED; plant++) {
		const member = members[memberOf[plant]];
		if (member && first[places.kind[plant]] === kind) found.add(member);
	}
	return [...found];
}

function meanOf(members: readonly Member[]): Colour {
	const all = members.flatMap(({ levels }) => levels.at(-1) ?? []);
	const flowers = all.filter(({ material }) => FLOWERS.test(material.name));
	const byName = new Map<string, MemberMesh[]>();
	for (const each of all) byName.set(each.material.name, [...(byName.get(each.material.name) ?? []), each]);
	const most = [...byName.values()].sort((one, other) => cornersOf(other) - cornersOf(one))[0];
	const told = flowers.length > 0 ? flowers : (most ?? []);
	let colour = UNGROWN;
	let weights = 0;
	for (const each of told) {
		const own = meshColour(each);
		// A bud is as green as it is yet dull.
		const weight = cornersOf([each]) * (DULL + toLch(own).chroma) ** 2;
		weights += weight;
		if (weight > 0) colour = mixed(colour, own, weight / weights);
	}
	return colour;
}

const cornersOf = (meshes: readonly MemberMesh[]): number =>
	meshes.reduce((sum, { mesh }) => sum + mesh.indices.length, 0);

function meshColour({ mesh: { colours, sky }, material }: MemberMesh): Colour {
	if (!colours) return material.colour;
	const sum: Colour = [0, 0, 0];
	for (let i = 0; i < colours.length; i++) sum[i % 3] += colours[i];
	return sum.map((value) => value / (COLOUR_STEPS * sky.length)) as Colour;
}

/** The least change first, and of lightness before hue: a sort's hue is what it is known by. */
function apartFrom(others: readonly Lch[], wanted: Lch): Lch {
	const free = (lch: Lch) => others.every((other) => distance(lch, other) >= APART);
	for (const turn of eitherWay(TURN, Math.PI))
		for (const more of eitherWay(STEP, LIGHTEST - LIGHT)) {
			const lightness = wanted.lightness + more;
			if (lightness < LIGHT || lightness > LIGHTEST) continue;
			const chroma = turn === 0 ? wanted.chroma : Math.max(0.1, wanted.chroma);
			const tried = { lightness, chroma, hue: wanted.hue + turn };
			// As it will be shown.
			if (free(toLch(fromLch(tried)))) return tried;
		}
	return wanted;
}

/** 0, step, -step, 2 step, …, up to that far. */
const eitherWay = (step: number, far: number): number[] =>
	[0].concat(...Array.from({ length: Math.floor(far / step) }, (_, i) => [step * (i + 1), -step * (i + 1)]));

function distance(one: Lch, other: Lch): number {
	const [a, b] = [one, other].map(({ chroma, hue }) => [chroma * Math.cos(hue), chroma * Math.sin(hue)]);
	return Math.hypot(one.lightness - other.lightness, a[0] - b[0], a[1] - b[1]);
}

const written = (colour: Colour): string =>
	`#${encoded(colour)
		.map((value) =>
			Math.round(255 * Math.min(1, Math.max(0, value)))
				.toString(16)
				.padStart(2, "0"),
		)
		.join("")}`;
