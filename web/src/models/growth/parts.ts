/** A tree of a growth grammar in parts: bark, leaves in their tints, those about to fall and those that lie on the ground. */
import { linear, mixed } from "../../plant/colour";
import { leafTints } from "../../plant/leaf_colours";
import type { Part } from "../../plant/part";
import type { Plant } from "../../plant/plant";
import { barkPicture } from "../../plant/wood/bark_picture";
import { type Dress, woodenParts } from "../../plant/wood/wooden_parts";
import type { GrowthPlant } from "./growth_plant";
import type { GrowthSpecimen } from "./specimen";

/** What twigs of any tree come near to. */
const TWIG = linear("4d3f33");

export function* growthParts(plant: GrowthPlant, { look }: GrowthSpecimen): Generator<Part> {
	const old = linear(look.bark);
	const dress: Dress = {
		wood: {
			name: "Bark",
			colour: old,
			roughness: 0.92,
			textures: { colour: barkPicture("furrowed"), repeats: true },
		},
		bark: { old, young: mixed(old, TWIG, 0.8), from: 0.008, to: 0.05 },
		tints: { blade: leafTints(look, plant.veins) },
	};
	const [kept, falling] = parted(plant);
	yield* woodenParts(kept, dress);
	if (falling.count === 0) return;
	// Those about to fall and the fallen are of one colour: a step later they are gone.
	const [material] = leafTints({ ...look, leaf: look.falling, autumn: look.falling, season: 0.4 }, plant.veins);
	const leaves = plant.meshes.filter(({ material: kind }) => kind === "blade");
	yield* woodenParts(
		{ ...plant, meshes: leaves, organs: { ...falling, mesh: new Int32Array(falling.count) } },
		{ ...dress, tints: { blade: [{ ...material, name: "Falling leaf" }] } },
	);
}

/** The same plant with the leaves that stay, and the organs that do not. */
function parted(plant: GrowthPlant): [kept: GrowthPlant, falling: Plant["organs"]] {
	const { organs } = plant;
	const stays = organs.tags.indexOf("leaf");
	const places = Array.from({ length: organs.count }, (_, i) => i);
	const kept = organsAt(
		organs,
		places.filter((i) => organs.tag[i] === stays),
	);
	return [
		{ ...plant, organs: kept },
		organsAt(
			organs,
			places.filter((i) => organs.tag[i] !== stays),
		),
	];
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
		tag: Uint8Array.from(places, (i) => organs.tag[i]),
		segment: Int32Array.from(places, (i) => organs.segment[i]),
		mesh: Int32Array.from(places, (i) => organs.mesh[i]),
		transforms,
		...(sky ? { sky: Uint8Array.from(places, (i) => sky[i]) } : {}),
	};
}
