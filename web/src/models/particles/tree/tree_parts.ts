/** A tree in parts: bark, leaves in their tints, particles on their way. */
import { linear, mixed } from "../../../plant/colour";
import type { Part } from "../../../plant/part";
import { obstacleParts } from "../boundary/obstacle_parts";
import { particleMaterial } from "../boundary/particle_material";
import { woodenParts } from "../boundary/wooden_parts";
import type { WoodenPlant } from "../boundary/wooden_plant";
import { leafTints } from "./leaf_colours";
import type { TreeSpecimen } from "./specimen";

/** What twigs of any tree come near to. */
const TWIG = linear("4d3f33");

export function* treeParts(plant: WoodenPlant, specimen: TreeSpecimen): Generator<Part> {
	const { look } = specimen;
	const old = linear(look.bark);
	yield* woodenParts(plant, {
		wood: { name: "Bark", colour: old, roughness: 0.92, grain: 0.5 },
		bark: { old, young: mixed(old, TWIG, 0.8), from: 0.008, to: 0.05 },
		tints: { blade: leafTints(look), skin: [particleMaterial] },
	});
	yield* obstacleParts(specimen);
}
