/** The parts of a tree: bark, tinted leaves, moving particles. */
import { linear, mixed, toLch } from "../../plant/colour";
import { leafTints } from "../../plant/leaf_colours";
import type { Part } from "../../plant/part";
import { barkPictures } from "../../plant/wood/bark_picture";
import { woodenParts } from "../../plant/wood/wooden_parts";
import { obstacleParts } from "../particles/boundary/obstacle_parts";
import { particleMaterial } from "../particles/boundary/particle_material";
import type { TreeSpecimen } from "./specimen";
import type { TreePlant } from "./tree_plant";

/** Colour that twigs of all species approach. */
const TWIG = linear("4d3f33");
/** Lightness from which bark is papery, as a birch's, and dark and rough at the base; darker bark is furrowed. */
const PALE = 0.8;
const FOOT = linear("2a2623");

/**
 * Yields the parts; twigs have a colour of their own up to a radius of 8 mm, which turns into that of the bark up to 50
 * mm.
 */
export function* treeParts(plant: TreePlant, specimen: TreeSpecimen): Generator<Part> {
	const { look } = specimen;
	const old = linear(look.bark);
	const pale = toLch(old).lightness > PALE;
	const { textures, mean, roughness } = barkPictures(pale ? "paper" : "furrowed");
	yield* woodenParts(plant, {
		wood: { name: "Bark", colour: mean, roughness, textures },
		bark: { old, young: mixed(old, TWIG, 0.8), mean, from: 0.008, to: 0.05, ...(pale ? { foot: FOOT } : {}) },
		tints: { blade: leafTints(look, plant.veins), skin: [particleMaterial] },
	});
	yield* obstacleParts(specimen);
}
