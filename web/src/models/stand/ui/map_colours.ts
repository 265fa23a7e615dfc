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
const MAX_GROUND_LIGHTNESS = 0.35;
const PLANT_LIGHTNESS = [0.63, 0.97] as const;
/** Number of plants whose colours are averaged: a single one may be in bud. */
const SAMPLES = 8;
/** Weight of grey colours relative to chroma. */
const DULL = 0.01;
const FLOWERS = /petal|flower|blossom|floret|berr/i;
const UNGROWN: Colour = [0.3, 0.32, 0.25];

/** Returns the colour of the ground on the map: the soil's, darkened where it is light. */
export function groundColour(soil: string): string {
	const lch = toLch(linear(soil));
	return hexColour(fromLch({ ...lch, lightness: Math.min(MAX_GROUND_LIGHTNESS, lch.lightness) }));
}

/** Returns the map's colour of each kind as `#rrggbb`; kinds of the same name share a colour. */
export function kindColours(stand: StandPlant): readonly string[] {
	const first = firstOfSameName(stand);
	const kinds = [...new Set(first)];
	const ownColours = kinds.map((kind) => toLch(mapColour(sampleMembers(stand, first, kind))));
	const colours = separateColours(ownColours, PLANT_LIGHTNESS).map((lch) => hexColour(fromLch(lch)));
	return first.map((kind) => colours[kinds.indexOf(kind)]);
}

/**
 * Returns at most SAMPLES grown members of a kind or of others of the same name.
 * @param first for each kind the first kind of the same name
 * @param kind the first kind of a name
 */
function sampleMembers({ places, memberOf, members }: StandPlant, first: readonly number[], kind: number): Member[] {
	const found = new Set<Member>();
	for (let plant = 0; plant < places.count && found.size < SAMPLES; plant++) {
		const member = members[memberOf[plant]];
		if (member && first[places.kind[plant]] === kind) found.add(member);
	}
	return [...found];
}

/**
 * Returns the colour by which the map shows plants: the mean of their flowers if they have any, else of the material
 * with most triangles.
 */
function mapColour(members: readonly Member[]): Colour {
	const coarsestMeshes = members.flatMap(({ levels }) => levels.at(-1) ?? []);
	const flowers = coarsestMeshes.filter(({ material }) => FLOWERS.test(material.name));
	const byName = new Map<string, MemberMesh[]>();
	for (const each of coarsestMeshes) byName.set(each.material.name, [...(byName.get(each.material.name) ?? []), each]);
	const largest = [...byName.values()].sort((one, other) => cornersOf(other) - cornersOf(one))[0];
	const meshes = flowers.length > 0 ? flowers : (largest ?? []);
	let colour = UNGROWN;
	let weights = 0;
	for (const each of meshes) {
		const itsColour = meshColour(each);
		// Weights by squared chroma: buds are still dull.
		const weight = cornersOf([each]) * (DULL + toLch(itsColour).chroma) ** 2;
		weights += weight;
		if (weight > 0) colour = mixed(colour, itsColour, weight / weights);
	}
	return colour;
}

/** Returns the number of the meshes' triangle corners. */
const cornersOf = (meshes: readonly MemberMesh[]): number =>
	meshes.reduce((sum, { mesh }) => sum + mesh.indices.length, 0);

/** Returns the mean of a mesh's vertex colours, or its material's colour where it has none. */
const meshColour = ({ mesh: { colours }, material }: MemberMesh): Colour =>
	colours ? (meanColour(colours).map((value) => value / COLOUR_STEPS) as Colour) : material.colour;

/** Writes a linear colour as `#rrggbb`. */
const hexColour = (colour: Colour): string =>
	`#${encoded(colour)
		.map((value) =>
			Math.round(255 * clamp(value))
				.toString(16)
				.padStart(2, "0"),
		)
		.join("")}`;
