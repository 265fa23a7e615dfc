/** Materials of a leaf. */
import { type Colour, linear, mix, mixed } from "../../../plant/colour";
import type { Material } from "../../../plant/material";
import type { LeafSpecimen } from "../specimen";

type Look = LeafSpecimen["look"];

/** Labels of the blade's faces, by the names of their meshes. */
export const FACES = { upper: "Blade, upper face", lower: "Blade, lower face" } as const;
export type Side = keyof typeof FACES;

/** Largest transmittance of each colour: light through a blade is yellower than the blade. */
const TRANSMITTANCE: Colour = [1, 1.05, 0.5];
/** Largest transmission in files. */
const MAX_TRANSMISSION = 0.25;
const PALE: Colour = [1, 0.95, 0.72];
const EVERYWHERE: Colour = [1, 1, 1];

/** Returns the colour of a face between its veins. */
export function faceColour({ green, under }: Look, side: Side): Colour {
	return linear((side === "upper" ? green : under) as string);
}

/**
 * Returns the material of a face of the blade. The two faces are a thin closed surface: light comes through from the
 * other face.
 */
export function bladeMaterial(look: Look, side: Side): Material {
	const { glow, gloss } = look;
	const shine = side === "lower" ? 0.3 * (gloss as number) : (gloss as number);
	return {
		name: FACES[side],
		colour: faceColour(look, side),
		roughness: mix(0.78, 0.3, shine),
		specular: mix(0.3, 1, shine),
		sheet: { through: TRANSMITTANCE.map((value) => value * (glow as number)) as Colour, reverse: EVERYWHERE },
	};
}

/**
 * Returns the transmission of the blade, for files whose materials have a volume; none where the leaf does not glow.
 * Transmitted light is brighter and more saturated than the green of the surface.
 * @param thickest largest thickness of the blade, metres
 * @param meanFreePath distance after which light has the transmitted colour, metres
 */
export function fleshOf({ green, glow }: Look, thickest: number, meanFreePath: number): Pick<Material, "flesh"> {
	const share = MAX_TRANSMISSION * (glow as number);
	if (share <= 0) return {};
	const colour = linear(green as string).map((value) => Math.min(1, 0.25 + 2.5 * value)) as Colour;
	return { flesh: { factor: share, thickness: thickest, colour, distance: meanFreePath } };
}

/** Returns the material of the petiole. */
export function petioleMaterial({ stalk }: Look): Material {
	return { name: "Petiole", colour: linear(stalk as string), roughness: 0.7 };
}

/** Returns the material of moving particles, which are lighter than the blade and the veins. */
export function particleMaterial({ vein_colour }: Look): Material {
	return { name: "Particle", colour: mixed(linear(vein_colour as string), PALE, 0.75), roughness: 0.5 };
}
