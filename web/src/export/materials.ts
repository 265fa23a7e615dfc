/** The two materials of a bunch as physically based values, shared by GLB and OBJ. */
import type { Look } from "../specimen/specimen";
import { rounded } from "./numbers";

export type Colour = [red: number, green: number, blue: number];

export interface Material {
	name: "Skin" | "Stem";
	/** Linear, 0 … 1. */
	colour: Colour;
	/** 0 mirror … 1 matt. */
	roughness: number;
	/** The waxy bloom of the skin as a sheen: linear colour and roughness. Absent where there is no bloom. */
	sheen?: { colour: Colour; roughness: number };
}

/** A smooth skin without wax; bloom scatters the highlight up to the second figure. */
const SKIN_ROUGHNESS: readonly [clean: number, bloomed: number] = [0.34, 0.46];
const STEM_ROUGHNESS = 0.85;
/** Wax crystals scatter a pale blue, strongest at grazing angles: what a sheen lobe describes. */
const BLOOM_COLOUR: Colour = [0.17, 0.2, 0.26];
const BLOOM_ROUGHNESS = 0.55;

/** What the scar and the dried style at the tip leave of the skin's colour: a brown over any skin. */
export const SCAR_TINT: Colour = [0.42, 0.3, 0.2];

export function skinMaterial(look: Look): Material {
	const [clean, bloomed] = SKIN_ROUGHNESS;
	const material: Material = {
		name: "Skin",
		colour: linear(look.skin),
		roughness: rounded(clean + (bloomed - clean) * look.bloom, 3),
	};
	if (look.bloom > 0) {
		const [red, green, blue] = BLOOM_COLOUR;
		const part = (value: number) => rounded(value * look.bloom, 4);
		material.sheen = { colour: [part(red), part(green), part(blue)], roughness: BLOOM_ROUGHNESS };
	}
	return material;
}

export function stemMaterial(look: Look): Material {
	return { name: "Stem", colour: linear(look.stem), roughness: STEM_ROUGHNESS };
}

/** `rrggbb` as three parts of sRGB, 0 … 1. */
export function srgb(hex: string): Colour {
	const bits = Number.parseInt(hex, 16);
	return [(bits >> 16) / 255, ((bits >> 8) & 255) / 255, (bits & 255) / 255];
}

/** `rrggbb` in sRGB to linear light (IEC 61966-2-1). */
function linear(hex: string): Colour {
	const decode = (c: number) => rounded(c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4, 6);
	const [red, green, blue] = srgb(hex);
	return [decode(red), decode(green), decode(blue)];
}
