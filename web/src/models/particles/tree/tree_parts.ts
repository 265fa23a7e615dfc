/** A tree in parts: bark, leaves in their tints, particles on their way. */
import { linear } from "../../../plant/colour";
import type { Part } from "../../../plant/part";
import { particleMaterial } from "../boundary/particle_material";
import { woodenParts } from "../boundary/wooden_parts";
import type { TrailPlant } from "../trails";
import { leafTints } from "./leaf_colours";
import type { TreeSpecimen } from "./specimen";

export function treeParts(plant: TrailPlant, { look }: TreeSpecimen): Iterable<Part> {
	const bark = { name: "Bark", colour: linear(look.bark), roughness: 0.92 };
	return woodenParts(plant, { bark }, { blade: leafTints(look), skin: [particleMaterial] });
}
