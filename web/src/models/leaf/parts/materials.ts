/** What a leaf is made of. */
import { type Colour, linear, mix, mixed } from "../../../plant/colour";
import type { Material } from "../../../plant/material";
import type { LeafSpecimen } from "../specimen";

type Look = LeafSpecimen["look"];

/** The faces of the blade, by the names of their meshes, as people call them. */
export const FACES = { upper: "Blade, upper face", lower: "Blade, lower face" } as const;
export type Side = keyof typeof FACES;

/** Light through a blade is yellower than it: how much of each colour comes through, at the most. */
const THROUGH: Colour = [1, 1.05, 0.5];
/** The most light that files let pass. */
const MOST_PASSING = 0.25;
const PALE: Colour = [1, 0.95, 0.72];
const EVERYWHERE: Colour = [1, 1, 1];

/** The look's colour of a face between its veins. */
export function faceColour({ green, under }: Look, side: Side): Colour {
	return linear((side === "upper" ? green : under) as string);
}

/** A face of the blade. Both together are closed, and thin: light comes through from the other one. */
export function bladeMaterial(look: Look, side: Side): Material {
	const { glow, gloss } = look;
	const shine = side === "lower" ? 0.3 * (gloss as number) : (gloss as number);
	return {
		name: FACES[side],
		colour: faceColour(look, side),
		roughness: mix(0.78, 0.3, shine),
		specular: mix(0.3, 1, shine),
		sheet: { through: THROUGH.map((value) => value * (glow as number)) as Colour, reverse: EVERYWHERE },
	};
}

/** The same for files, which tell light that passes by the flesh it passes: so thick at the most, as wide as light goes on average. */
export function fleshOf({ green, glow }: Look, thickest: number, thickness: number): Pick<Material, "flesh"> {
	const share = MOST_PASSING * (glow as number);
	if (share <= 0) return {};
	const colour = linear(green as string).map((value) => Math.min(1, 0.25 + 2.5 * value)) as Colour;
	return { flesh: { factor: share, thickness: thickest, colour, distance: thickness } };
}

export function petioleMaterial({ stalk }: Look): Material {
	return { name: "Petiole", colour: linear(stalk as string), roughness: 0.7 };
}

/** Particles on their way: lighter than any blade, and than the veins that they leave. */
export function particleMaterial({ vein_colour }: Look): Material {
	return { name: "Particle", colour: mixed(linear(vein_colour as string), PALE, 0.75), roughness: 0.5 };
}
