/** The colours of a stand's map: each sort has that of its flowers, or, where it has none, of its leaves, on ground as dark as it takes to tell them. Pure. */
import { type Colour, clamp, encoded, fromLch, linear, meanColour, mixed, toLch } from "../../../plant/colour";
import { COLOUR_STEPS } from "../../../plant/packed_mesh";
import type { Member, MemberMesh } from "../../model";
import { firstAlike } from "../members";
import type { StandPlant } from "../stand_plant";
import { separateColours } from "./separate_colours";

/** Lightness that ground has at the most and plants at the least: three times the light apart, so that none is lost on it. */
const DARKEST = 0.35;
const LIGHT = 0.63;
const LIGHTEST = 0.97;
/** So many plants of a sort say what it looks like: one may be in bud. */
const SAMPLES = 8;
/** What is without colour counts so much beside chroma. */
const DULL = 0.01;
const FLOWERS = /petal|flower|blossom|floret|berr/i;
const UNGROWN: Colour = [0.3, 0.32, 0.25];

export function groundColour(soil: string): string {
	const lch = toLch(linear(soil));
	return written(fromLch({ ...lch, lightness: Math.min(DARKEST, lch.lightness) }));
}

/** Of each kind; those that are called the same have one. */
export function kindColours(stand: StandPlant): readonly string[] {
	const first = firstAlike(stand);
	const kinds = [...new Set(first)];
	const seen = kinds.map((kind) => toLch(meanOf(membersOf(stand, first, kind))));
	const colours = separateColours(seen, [LIGHT, LIGHTEST]).map((lch) => written(fromLch(lch)));
	return first.map((kind) => colours[kinds.indexOf(kind)]);
}

function membersOf({ places, memberOf, members }: StandPlant, first: readonly number[], kind: number): Member[] {
	const found = new Set<Member>();
	for (let plant = 0; plant < places.count && found.size < SAMPLES; plant++) {
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
	const meshes = flowers.length > 0 ? flowers : (most ?? []);
	let colour = UNGROWN;
	let weights = 0;
	for (const each of meshes) {
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

const meshColour = ({ mesh: { colours }, material }: MemberMesh): Colour =>
	colours ? (meanColour(colours).map((value) => value / COLOUR_STEPS) as Colour) : material.colour;

const written = (colour: Colour): string =>
	`#${encoded(colour)
		.map((value) =>
			Math.round(255 * clamp(value))
				.toString(16)
				.padStart(2, "0"),
		)
		.join("")}`;
