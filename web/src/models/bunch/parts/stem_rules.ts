/**
 * How stems are coloured: the numbers of the rules that the view's shader (figure/stem_material.ts) and the files' colours
 * (stem_colour.ts) follow. Green first, woody as the berries turn and dry, from the nodes and along the bark's streaks, the
 * rachis first and pedicels last. Estimates by eye.
 */
import type { Colour } from "../../../plant/colour";
import type { BunchPlant } from "../bunch_plant";
import { meanOf } from "../traits";

/** Noise cells of the mottling: to one turn of u, to one of v, to a metre of height. */
export const MOTTLES = [14, 3, 90] as const;
/** By how much less wood each kind of internode has than the one before. */
export const LATER = 0.3;
/** What young skin makes of the look's green, and until which share of wood. */
export const YOUNG = { colour: [0.82, 1.12, 0.72] as Colour, until: 1.6 } as const;
/** What bark makes of it, at its first and at its last, and dry. */
export const BARK = {
	first: [0.92, 0.62, 0.5] as Colour,
	last: [0.8, 0.48, 0.36] as Colour,
	light: 0.85,
	dry: 0.5,
} as const;
/** Where brown shows: at nodes, in streaks, on what has withered, and all over as wood spreads. */
export const BROWN = {
	/** Of an internode so many times as long as thick; shorter ones would be ringed. */
	node: { from: 0.72, share: 0.45, young: 0.3, slender: [1.5, 4] },
	streak: { from: 0.45, to: 0.85, share: 0.5, young: 0.4 },
	withered: 0.75,
	wood: { from: 0.35, to: 1.1, share: 0.9, mottle: 0.3 },
} as const;
/** The factor on the colour goes from `least` by `span` with the mottling. */
export const SHADE = { least: 1.14, span: 0.42 } as const;

/** The paper's bunches have no age; theirs is a ripe one's wood. */
const PAPER_WOOD = 0.55;

/** How far a bunch's stems have turned woody, 0 … 1: they do as the berries colour, and go on as these dry. */
export function woodOf({ berries, procedure }: BunchPlant): number {
	if (procedure === "paper") return PAPER_WOOD;
	return 0.55 * meanOf(berries, "turned", 1) + 0.45 * meanOf(berries, "shrivel", 0);
}
