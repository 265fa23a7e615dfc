/**
 * Rules of stem colours: numbers shared by the view (render/stem_streams.ts) and the files' colours (stem_colour.ts).
 * Stems are green first and turn woody as the berries turn and dry, from the nodes and along streaks, the rachis first
 * and pedicels last. Estimates by eye.
 */
import type { Colour } from "../../../plant/colour";
import type { BunchPlant } from "../bunch_plant";
import { meanOf } from "../traits";

/** Noise cells of the mottling: to one turn of u, to one of v, to a metre of height. */
export const MOTTLES = [14, 3, 90] as const;
/** Decrease of wood from each kind of internode to the next. */
export const LATER = 0.3;
/** Factor of young skin on the look's green, and the share of wood at which it ends. */
export const YOUNG = { colour: [0.82, 1.12, 0.72] as Colour, until: 1.6 } as const;
/** Factors of bark on the look's green, first and last, and when dry. */
export const BARK = {
	first: [0.92, 0.62, 0.5] as Colour,
	last: [0.8, 0.48, 0.36] as Colour,
	light: 0.85,
	dry: 0.5,
} as const;
/** Where brown appears: at nodes, in streaks, on withered stems, and all over as wood spreads. */
export const BROWN = {
	/** Range of length over thickness in which nodes appear; shorter internodes would look ringed. */
	node: { from: 0.72, share: 0.45, young: 0.3, slender: [1.5, 4] },
	streak: { from: 0.45, to: 0.85, share: 0.5, young: 0.4 },
	withered: 0.75,
	wood: { from: 0.35, to: 1.1, share: 0.9, mottle: 0.3 },
} as const;
/** Mottling: the factor on the colour goes from `least` by `span`. */
export const SHADE = { least: 1.14, span: 0.42 } as const;

/** Share of wood of the paper's bunches, which have no age: that of a ripe bunch. */
const PAPER_WOOD = 0.55;

/** Returns how far a bunch's stems have turned woody, 0 … 1: as the berries colour, and further as they dry. */
export function woodOf({ berries, procedure }: BunchPlant): number {
	if (procedure === "paper") return PAPER_WOOD;
	return 0.55 * meanOf(berries, "turned", 1) + 0.45 * meanOf(berries, "shrivel", 0);
}
