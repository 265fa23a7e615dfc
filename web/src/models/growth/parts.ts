/** Splits a tree into parts: bark, leaves in their tints, twigs, blossoms, leaves about to fall and leaves on the ground. */
import { linear } from "../../plant/colour";
import { leafTints } from "../../plant/leaf_colours";
import type { Material } from "../../plant/material";
import type { Part } from "../../plant/part";
import { partsOf } from "../../plant/parts_of";
import { EMPTY_PLANT, type Plant } from "../../plant/plant";
import { type BarkKind, barkPictures } from "../../plant/wood/bark_picture";
import { attachedParts, type WoodMaterials, woodenParts } from "../../plant/wood/wooden_parts";
import type { GrowthPlant } from "./growth_plant";
import type { GrowthSpecimen } from "./specimen";
import { GROWTH_TABLE } from "./table";
import { leafSeason } from "./year";

/** Colour of dead wood, weathered to grey. */
const DEAD_WOOD = linear("9d968a");

/** Materials of the ends of cut and broken branches, by the kind of their meshes. */
const CUT_WOOD: Readonly<Record<string, Material>> = {
	cut: { name: "Cut wood", colour: linear("c9a878"), roughness: 0.85 },
	dead: { name: "Broken wood", colour: linear("a89a84"), roughness: 0.95 },
};

/** Colour of a birch's bark near the ground. */
const FOOT = linear("2a2623");

/** Season of fallen leaves' colours in autumn: browner than leaves on the tree. */
const LYING_SEASON = 1;

/** Yields the parts of the plant: wood with leaves, twigs, leaves that fall or lie, blossoms, bunches. */
export function* growthParts(plant: GrowthPlant, specimen: GrowthSpecimen): Generator<Part> {
	const { look, parameters } = specimen;
	const evergreen = GROWTH_TABLE.option(specimen, "year") === "evergreen";
	const dress = woodOf(specimen);
	const season = leafSeason(parameters.season, evergreen);
	const kind = GROWTH_TABLE.option(specimen, "leaf_kind");
	const colours = { leaf: look.leaf, autumn: look.autumn, ...(kind === undefined ? {} : { kind }) };
	// The ends of cut branches come after the meshes of organs, whose indices stay the same without them.
	const cut = plant.meshes.filter(({ material }) => Object.hasOwn(CUT_WOOD, material));
	const whole = cut.length > 0 ? { ...plant, meshes: plant.meshes.filter((mesh) => !cut.includes(mesh)) } : plant;
	yield* partsOf({ meshes: cut, organs: EMPTY_PLANT.organs }, CUT_WOOD);
	yield* woodenParts(withOrgans(whole, ["leaf"]), {
		...dress,
		tints: { blade: leafTints({ ...colours, season }, plant.veins), petal: [], twig: [] },
	});
	yield* attachedParts(withOrgans(plant, ["twig"]), { twig: [twig(look.young_bark)] });
	// Falling and fallen leaves have one colour: they disappear a step later.
	const [red] = leafTints({ leaf: look.falling, autumn: look.falling, season: 0.4 }, plant.veins);
	yield* attachedParts(withOrgans(plant, ["falling", "fallen"]), { blade: [{ ...red, name: "Falling leaf" }] });
	const brown = leafTints({ ...colours, season: LYING_SEASON }, plant.veins);
	yield* attachedParts(withOrgans(plant, ["shed"]), {
		blade: brown.map((tint, i) => ({ ...tint, name: `Shed leaf ${i + 1}` })),
	});
	yield* attachedParts(withOrgans(plant, ["blossom"]), { petal: [petal(look.petal)] });
}

/** Returns the materials of the wood: old and young bark, and how thick stems are between which they change. */
function woodOf(specimen: GrowthSpecimen): Omit<WoodMaterials, "tints"> {
	const { look } = specimen;
	const kind = BARKS[GROWTH_TABLE.option(specimen, "bark_kind") ?? ""] ?? "furrowed";
	const old = linear(look.bark);
	const { textures, mean, roughness } = barkPictures(kind);
	const oldRadius = 0.005 * look.bark_from;
	return {
		wood: {
			name: "Bark",
			colour: mean,
			roughness,
			textures,
		},
		bark: {
			old,
			young: linear(look.young_bark),
			mean,
			from: 0.15 * oldRadius,
			to: oldRadius,
			dead: DEAD_WOOD,
			...(kind === "paper" ? { foot: FOOT } : {}),
		},
	};
}

/** Kinds of bark by their names in the table. */
const BARKS: Readonly<Record<string, BarkKind>> = {
	furrowed: "furrowed",
	smooth: "smooth",
	paper: "paper",
	plated: "plated",
	banded: "banded",
	stringy: "fibrous",
};

/** Returns the material of twigs' wood of a colour. */
const twig = (colour: string): Material => ({ name: "Twig", colour: linear(colour), roughness: 0.85 });

/** Returns the material of blossoms of a colour. */
const petal = (colour: string): Material => ({
	name: "Petal",
	colour: linear(colour),
	roughness: 0.65,
	doubleSided: true,
	sheet: { through: [0.9, 0.85, 0.85], reverse: [1, 0.98, 0.98] },
});

/** Returns the plant with only the organs that have one of these tags and a mesh. */
function withOrgans(plant: GrowthPlant, tags: readonly string[]): GrowthPlant {
	const { organs } = plant;
	const codes = new Set(tags.map((tag) => organs.tags.indexOf(tag)));
	const indices: number[] = [];
	for (let i = 0; i < organs.count; i++) if (codes.has(organs.tag[i]) && organs.mesh[i] >= 0) indices.push(i);
	return { ...plant, organs: organsAt(organs, indices) };
}

/** Returns the organs of these indices as columns of their own. */
function organsAt(organs: Plant["organs"], indices: readonly number[]): Plant["organs"] {
	if (indices.length === organs.count) return organs;
	const { sky } = organs;
	const width = organs.transforms.length / Math.max(1, organs.count);
	const transforms = new Float32Array(width * indices.length);
	indices.forEach((index, i) => {
		transforms.set(organs.transforms.subarray(width * index, width * (index + 1)), width * i);
	});
	return {
		...organs,
		count: indices.length,
		tag: Uint32Array.from(indices, (i) => organs.tag[i]),
		segment: Int32Array.from(indices, (i) => organs.segment[i]),
		mesh: Int32Array.from(indices, (i) => organs.mesh[i]),
		transforms,
		...(sky ? { sky: Uint8Array.from(indices, (i) => sky[i]) } : {}),
	};
}
