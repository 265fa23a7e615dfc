/** A tree in parts: bark, leaves in their tints, particles on their way. */
import { linear, mixed, toLch } from "../../plant/colour";
import { leafTints } from "../../plant/leaf_colours";
import type { Part } from "../../plant/part";
import { barkPicture } from "../../plant/wood/bark_picture";
import { woodenParts } from "../../plant/wood/wooden_parts";
import { obstacleParts } from "../particles/boundary/obstacle_parts";
import { particleMaterial } from "../particles/boundary/particle_material";
import type { TreeSpecimen } from "./specimen";
import type { TreePlant } from "./tree_plant";

/** What twigs of any tree come near to. */
const TWIG = linear("4d3f33");
/** Bark as light as a birch's is paper that turns dark and rough at the foot; all other bark is furrowed. */
const PALE = 0.8;
const FOOT = linear("2a2623");

export function* treeParts(plant: TreePlant, specimen: TreeSpecimen): Generator<Part> {
	const { look } = specimen;
	const old = linear(look.bark);
	const pale = toLch(old).lightness > PALE;
	yield* woodenParts(plant, {
		wood: {
			name: "Bark",
			colour: old,
			roughness: pale ? 0.75 : 0.92,
			textures: { colour: barkPicture(pale ? "paper" : "furrowed"), repeats: true },
		},
		bark: { old, young: mixed(old, TWIG, 0.8), from: 0.008, to: 0.05, ...(pale ? { foot: FOOT } : {}) },
		tints: { blade: leafTints(look, plant.veins), skin: [particleMaterial] },
	});
	yield* obstacleParts(specimen);
}
