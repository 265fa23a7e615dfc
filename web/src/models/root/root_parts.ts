/** The parts of a root: the roots, and moving particles. */
import { linear, mixed } from "../../plant/colour";
import type { Part } from "../../plant/part";
import { barkPictures } from "../../plant/wood/bark_picture";
import { woodenParts } from "../../plant/wood/wooden_parts";
import { obstacleParts } from "../particles/boundary/obstacle_parts";
import { particleMaterial } from "../particles/boundary/particle_material";
import type { WoodenPlant } from "../particles/boundary/wooden_plant";
import type { RootSpecimen } from "./specimen";

/** Colour that fine roots of all species approach. */
const FINE = linear("d9c7a0");

/**
 * Yields the parts; roots have a colour of their own up to a radius of 0.5 mm, which turns into that of old ones up to
 * 8 mm.
 */
export function* rootParts(plant: WoodenPlant, specimen: RootSpecimen): Generator<Part> {
	const { look } = specimen;
	const old = linear(look.root);
	const { textures, mean, roughness } = barkPictures(specimen.parameters.storage > 0 ? "ringed" : "fibrous");
	yield* woodenParts(plant, {
		wood: { name: "Root", colour: mean, roughness, textures },
		bark: { old, mean, young: mixed(old, FINE, 0.55), from: 0.0005, to: 0.008 },
		tints: { skin: [particleMaterial] },
	});
	yield* obstacleParts(specimen);
}
