/**
 * Colours of a stand's map: each kind has the colour of its flowers or, without flowers, of its leaves, on a ground
 * dark enough for contrast. Pure.
 */
import { type Colour, clamp, encoded, fromLch, linear, meanColour, mixed, toLch } from "../../../plant/colour";
import { COLOUR_STEPS } from "../../../plant/packed_mesh";
import type { Member, MemberMesh } from "../../model";
import { firstOfSameName } from "../members";
import type { StandPlant } from "../stand_plant";
import { separateColours } from "./separate_colours";

/** Greatest lightness of the ground, and range of lightness of plants: a contrast of three to one. */
const DARKEST = 0.35;
const LIGHT = 0.63;
const LIGHTEST = 0.97;
/** Number of plants whose colours are averaged: a single one may be in bud. */
const SAMPLES = 8;
/** Weight of grey colours relative to chroma. */
const DULL = 0.01;
const FLOWERS = /petal|flower|blossom|floret|berr/i;
const UNGROWN: Colour = [0.3, 0.32, 0.25];

export function groundColour(soil: string): string {
	const lch = toLch(linear(soil));
	return written(fromLch({ ...lch, lightness: Math.min(DARKEST, lch.lightness) }));
}

/** Colours by kind; kinds of the same name share a colour. */
export function kindColours(stand: StandPlant): readonly string[] {
	const first = firstOfSameName(stand);
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
		// Weights by squared chroma: buds are still dull.
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
