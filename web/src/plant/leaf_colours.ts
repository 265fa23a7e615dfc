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

/** How much the hue of single leaves differs, radians. */
const UNEVEN_HUE = 0.05;

/**
 * Colours of the upper and the lower side by kind of leaf, sRGB: the lower side of a leaf reflects more (Gates et al.
 * 1965; Woolley 1971), most where it is hairy (willow) or scaly (olive). The hues and the lightness are estimates about
 * the measured mean of foliage, `576c43` (McCamy, Marcus and Davidson 1976).
 */
const SIDES: Readonly<Record<string, readonly [upper: string, lower: string]>> = {
	vine: ["4f6b35", "7f9162"],
	oak: ["475f30", "7e9068"],
	beech: ["4c6a33", "728a50"],
	willow: ["6f8166", "a9b7a4"],
	lime: ["51703a", "8aa06a"],
	maple: ["4b6b31", "7c9460"],
	birch: ["5b7a38", "86a063"],
	olive: ["5f6f58", "b4bbaa"],
};
/** Colour of the lower side of other leaves as a factor on that of the upper one. */
const LOWER: Colour = [1.25, 1.2, 1.35];
/** Share of the table's difference between the sides that is shown: leaves bend, and few are seen from exactly below. */
const SIDE_SHARE = 0.5;

/** Returns the colour of the lower side of a kind of leaf as a factor on that of the upper one; never darker. */
export function undersideOf(kind: string | undefined): Colour {
	const sides = kind === undefined ? undefined : SIDES[kind];
	if (!sides) return LOWER;
	const [upper, lower] = sides.map(linear);
	return upper.map((value, k) => Math.max(1, 1 + SIDE_SHARE * (lower[k] / value - 1))) as Colour;
}

export interface LeafLook {
	/** Six hexadecimal digits. */
	leaf: string;
	autumn: string;
	/** 0 spring, 0.4 summer, 1 autumn. */
	season: number;
	/** Name of the baked leaf, for the colour of its lower side. */
	kind?: string;
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
 * Returns one material per tint, by how far ahead its leaves are. Neighbouring tints are alike, because the leaves of a
 * branch have neighbouring ones (wood/wooden_parts.ts); half of the differences are not in that order.
 * @param veins veins of all leaves; without them leaves are plain
 */
export function leafTints(look: LeafLook, veins?: Veins): Material[] {
	return Array.from({ length: TINTS }, (_, tint) => {
		const share = tint / (TINTS - 1) - 0.5;
		const turning = look.season > SUMMER ? Math.min(1, (look.season - SUMMER) / 0.2) : 0;
		const { lightness, chroma, hue } = toLch(leafColour(look, SPREAD * share * turning));
		const colour = fromLch({
			lightness: lightness * (1 + UNEVEN * (0.5 * ORDER[tint] + share)),
			chroma,
			hue: hue + UNEVEN_HUE * (0.5 * ORDER[TINTS - 1 - tint] - share),
		});
		return {
			name: `Leaf ${tint + 1}`,
			colour,
			roughness: 0.48,
			doubleSided: true,
			sheet: { through: [0.8, 0.85, 0.5], reverse: undersideOf(look.kind) },
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
