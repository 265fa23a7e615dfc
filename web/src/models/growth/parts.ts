/** Splits a tree into parts: bark, leaves in their tints, blossoms, leaves about to fall and leaves on the ground. */
import { linear } from "../../plant/colour";
import { leafTints } from "../../plant/leaf_colours";
import type { Material } from "../../plant/material";
import type { Part } from "../../plant/part";
import type { Plant } from "../../plant/plant";
import { type BarkKind, barkPicture, barkRelief } from "../../plant/wood/bark_picture";
import { attachedParts, type WoodMaterials, woodenParts } from "../../plant/wood/wooden_parts";
import type { GrowthPlant } from "./growth_plant";
import type { GrowthSpecimen } from "./specimen";
import { GROWTH_TABLE } from "./table";
import { leafSeason } from "./year";

/** Colour of a birch's bark near the ground. */
const FOOT = linear("2a2623");

/** Season of fallen leaves' colours in autumn: browner than leaves on the tree. */
const LYING = 1;

export function* growthParts(plant: GrowthPlant, specimen: GrowthSpecimen): Generator<Part> {
	const { look, parameters } = specimen;
	const evergreen = GROWTH_TABLE.option(specimen, "year") === "evergreen";
	const dress = woodOf(specimen);
	const season = leafSeason(parameters.season, evergreen);
	const colours = { leaf: look.leaf, autumn: look.autumn };
	yield* woodenParts(withOrgans(plant, ["leaf"]), {
		...dress,
		tints: { blade: leafTints({ ...colours, season }, plant.veins), petal: [] },
	});
	// Falling and fallen leaves have one colour: a step later they are gone.
	const [red] = leafTints({ leaf: look.falling, autumn: look.falling, season: 0.4 }, plant.veins);
	yield* attachedParts(withOrgans(plant, ["falling", "fallen"]), { blade: [{ ...red, name: "Falling leaf" }] });
	const brown = leafTints({ ...colours, season: LYING }, plant.veins);
	yield* attachedParts(withOrgans(plant, ["shed"]), {
		blade: brown.map((tint, i) => ({ ...tint, name: `Shed leaf ${i + 1}` })),
	});
	yield* attachedParts(withOrgans(plant, ["blossom"]), { petal: [petal(look.petal)] });
}

function woodOf(specimen: GrowthSpecimen): Omit<WoodMaterials, "tints"> {
	const { look } = specimen;
	const kind = BARKS[GROWTH_TABLE.option(specimen, "bark_kind") ?? ""] ?? "furrowed";
	const old = linear(look.bark);
	const thick = 0.005 * look.bark_from;
	return {
		wood: {
			name: "Bark",
			colour: old,
			roughness: kind === "paper" || kind === "smooth" ? 0.75 : 0.92,
			textures: { colour: barkPicture(kind), normal: barkRelief(kind), repeats: true },
		},
		bark: {
			old,
			young: linear(look.young_bark),
			from: 0.15 * thick,
			to: thick,
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
	const wanted = new Set(tags.map((tag) => organs.tags.indexOf(tag)));
	const places: number[] = [];
	for (let i = 0; i < organs.count; i++) if (wanted.has(organs.tag[i]) && organs.mesh[i] >= 0) places.push(i);
	return { ...plant, organs: organsAt(organs, places) };
}

function organsAt(organs: Plant["organs"], places: readonly number[]): Plant["organs"] {
	if (places.length === organs.count) return organs;
	const { sky } = organs;
	const width = organs.transforms.length / Math.max(1, organs.count);
	const transforms = new Float32Array(width * places.length);
	places.forEach((place, i) => {
		transforms.set(organs.transforms.subarray(width * place, width * (place + 1)), width * i);
	});
	return {
		...organs,
		count: places.length,
		tag: Uint32Array.from(places, (i) => organs.tag[i]),
		segment: Int32Array.from(places, (i) => organs.segment[i]),
		mesh: Int32Array.from(places, (i) => organs.mesh[i]),
		transforms,
		...(sky ? { sky: Uint8Array.from(places, (i) => sky[i]) } : {}),
	};
}
