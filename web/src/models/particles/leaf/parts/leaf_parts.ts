/** A leaf in parts: its blade in colours of its own, its petiole, and what is on its way. */
import { type Colour, linear, mix } from "../../../../plant/colour";
import type { Material } from "../../../../plant/material";
import type { Part } from "../../../../plant/part";
import { partsOf } from "../../../../plant/parts_of";
import type { Leaf } from "../grown";
import type { LeafSpecimen } from "../specimen";
import { bladeColours } from "./blade_colour";

/** @throws Error with a message for people where the leaf was asked for without meshes */
export function* leafParts(leaf: Leaf, { look }: Pick<LeafSpecimen, "look">): Generator<Part> {
	if (leaf.meshes.length === 0) throw new Error("This growth has no meshes to export: grow it with meshes.");
	const materials = leafMaterials(look);
	for (const part of partsOf(leaf, materials)) {
		const { shape } = part;
		if (shape?.material !== materials.blade) {
			yield part;
			continue;
		}
		const { positions } = shape.mesh;
		const { veined, away } = leaf;
		const colours = bladeColours({ positions, veined, away }, look, look.green as string);
		yield { ...part, shape: { ...shape, mesh: { ...shape.mesh, colours }, variant: "" } };
	}
}

/** Light through a blade is yellower than it: how much of each colour comes through, at most. */
const THROUGH: Colour = [0.95, 1, 0.4];

/** By the kinds of material that the core's meshes name. */
export function leafMaterials(look: LeafSpecimen["look"]): Record<"blade" | "stem" | "particle", Material> {
	const [green, under] = [linear(look.green as string), linear(look.under as string)];
	const autumn = look.autumn as number;
	const reverse = green.map((value, k) => mix(under[k] / Math.max(value, 0.01), 1.1, autumn)) as Colour;
	const glow = look.glow as number;
	return {
		blade: {
			name: "Blade",
			colour: green,
			roughness: mix(0.8, 0.32, look.gloss as number),
			specular: mix(0.35, 1, look.gloss as number),
			doubleSided: true,
			sheet: { through: THROUGH.map((value) => value * 1.7 * glow) as Colour, reverse },
		},
		stem: { name: "Petiole", colour: linear(look.stalk as string), roughness: 0.75 },
		particle: { name: "Particle", colour: linear(look.vein_colour as string), roughness: 0.5 },
	};
}
