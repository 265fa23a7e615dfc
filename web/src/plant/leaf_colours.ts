/** The colours of leaves through the year: each leaf turns on a day of its own. */
import { type Colour, clamp, fromLch, linear, mixed, toLch } from "./colour";
import type { Veins } from "./leaf";
import { leafPicture } from "./leaf_picture";
import type { Material } from "./material";

/** The number of visibly different kinds of leaves. */
const TINTS = 6;
/** The season of summer. */
const SUMMER = 0.4;
/** Share of the year between the first and the last leaf to turn. */
const SPREAD = 0.3;
/** How much lighter or darker single leaves are. */
const UNEVEN = 0.1;

export interface LeafLook {
	/** Six hexadecimal digits. */
	leaf: string;
	autumn: string;
	/** 0 spring, 0.4 summer, 1 autumn. */
	season: number;
}

/**
 * Returns the colour of a leaf.
 * @param ahead share of the year by which it is ahead of the others
 */
export function leafColour({ leaf, autumn, season }: LeafLook, ahead = 0): Colour {
	const summer = linear(leaf);
	if (season <= SUMMER) {
		// Young leaves are lighter and yellower.
		const { lightness, chroma, hue } = toLch(summer);
		const youth = clamp((SUMMER - season) / SUMMER);
		return fromLch({
			lightness: lightness + 0.13 * youth,
			chroma: chroma * (1 + 0.25 * youth),
			hue: hue - 0.16 * youth,
		});
	}
	const turned = clamp((season + ahead - SUMMER) / (1 - SUMMER));
	return mixed(summer, linear(autumn), turned * turned * (3 - 2 * turned));
}

/**
 * Returns one material per tint, by how far ahead its leaves are.
 * @param veins veins of all leaves; without them leaves are plain
 */
export function leafTints(look: LeafLook, veins?: Veins): Material[] {
	return Array.from({ length: TINTS }, (_, tint) => {
		const share = tint / (TINTS - 1) - 0.5;
		const turning = look.season > SUMMER ? Math.min(1, (look.season - SUMMER) / 0.2) : 0;
		const { lightness, chroma, hue } = toLch(leafColour(look, SPREAD * share * turning));
		const colour = fromLch({
			lightness: lightness * (1 + UNEVEN * ORDER[tint]),
			chroma,
			hue: hue + 0.05 * ORDER[TINTS - 1 - tint],
		});
		return {
			name: `Leaf ${tint + 1}`,
			colour,
			roughness: 0.48,
			doubleSided: true,
			sheet: { through: [0.8, 0.85, 0.5], reverse: [1.25, 1.2, 1.35] },
			...(veins ? { textures: { colour: leafPicture(veins, colour, veinColour(colour)) } } : {}),
		};
	});
}

/** Returns the colour of veins, paler than the blade. */
function veinColour(blade: Colour): Colour {
	const { lightness, chroma, hue } = toLch(blade);
	return fromLch({ lightness: Math.min(0.95, lightness + 0.16), chroma: 0.9 * chroma, hue: hue - 0.08 });
}

/** How light each tint is, −1 … 1: not in the order in which the tints turn. */
const ORDER = [0.2, -0.6, 1, -1, 0.6, -0.2];
