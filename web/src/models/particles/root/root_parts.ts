/** A root in parts: the roots themselves, and particles on their way. */
import { linear } from "../../../plant/colour";
import type { Part } from "../../../plant/part";
import { particleMaterial } from "../boundary/particle_material";
import { woodenParts } from "../boundary/wooden_parts";
import type { TrailPlant } from "../trails";
import type { RootSpecimen } from "./specimen";

export function rootParts(plant: TrailPlant, { look }: RootSpecimen): Iterable<Part> {
	const root = { name: "Root", colour: linear(look.root), roughness: 0.85 };
	return woodenParts(plant, { root, bark: root }, { skin: [particleMaterial] });
}
