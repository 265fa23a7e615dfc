/**
 * How a berry's skin is coloured at a point: the numbers of the rules that the view's shaders (figure/berry_shader.ts)
 * follow per pixel and the files' colours (berry_colour.ts) at each vertex. Estimates by eye.
 */
import type { Colour } from "../../../plant/colour";

/** Noise: cells to a berry's radius, and how far apart berries stand in it, by their phase. */
export interface Pattern {
	readonly cells: number;
	readonly phase: number;
}

/** What vertices can show, and what they cannot. */
export const COARSE: Pattern = { cells: 1.7, phase: 61 };
export const FINE: Pattern = { cells: 9, phase: 23 };

/** Pigment absorbs: colours mix as depths do, as logarithms, beside this least light. */
export const LEAST_LIGHT = 0.004;

/**
 * Turning starts at the tip (`along` the axis, −1 at the seat … 1) and in patches (`coarse`, `fine` noise), and runs over a
 * berry in a `width`; an `uneven` look widens it and makes patches.
 */
export const TURNING = { width: 0.35, uneven: 0.5, along: 0.32, coarse: 0.75, fine: 0.3 } as const;

/** Mottling: the factor on the colour goes from `least` by `span` with the coarse noise, by so much of it. */
export const MOTTLE = { least: 0.86, span: 0.28, share: 0.4, uneven: 1.2 } as const;

/** About the pedicel's seat, up to v = `to`, little pigment reaches the skin. */
export const SEAT = { from: 0.03, to: 0.13, share: 0.7, skin: 0.75, colour: [0.05, 0.055, 0.02] as Colour } as const;

/** The corky brown of the tip scar and of what is left of the style, over what shows of the skin; its edge is so soft in v. */
export const SCAR = { edge: 0.016, share: 0.72, skin: 0.25, colour: [0.17, 0.105, 0.055] as Colour } as const;

/** Before the scar, over so much of v, the skin is paler. */
export const HALO = { width: 0.06, end: 0.005, share: 0.4, skin: 1.2, light: 0.01 } as const;

/**
 * Pale ripe skins turn amber where the sun finds them: towards it (the cosine to its direction, and with it the coarse
 * noise) from `from` to `to`, to `colour` times their own.
 */
export const AMBER = { from: 0.05, to: 1.05, coarse: 0.7, colour: [1.0, 0.77, 0.34] as Colour } as const;

/** What drying adds to the absorption of flesh, per radius: raisins of pale grapes are amber, then brown. */
export const BROWNED: Colour = [0.45, 0.8, 1.25];

/**
 * Between clear berries light goes through neighbours as well as off them, and so grows warm: of it comes back, in place of the
 * skin's albedo, up to that one's root times this, the more the clearer they are.
 */
export const AMONG_CLEAR: Colour = [1, 0.88, 0.6];

/** A rind is blotched: its factor goes from `least` by `span` with the fine noise. What is more of one than `from` has its relief. */
export const RIND = { least: 0.72, span: 0.45, from: 0.1 } as const;

/**
 * Wax lies thinner below and in patches, is rubbed off where berries touch and where something brushed by, and goes as a
 * berry dries. Seen at `facing` (the cosine to the normal) it hides 1 − exp(−depth / (grazing + facing)) of the skin.
 */
export const WAX = {
	depth: 1.2,
	grazing: 0.25,
	rubbed: 0.12,
	pressed: [0.02, 0.5],
	pressedFine: 0.25,
	brushed: [0.16, 0.34],
	fine: 0.22,
	bare: 0.35,
	patches: [0.12, 0.75],
	coarseShare: 0.7,
	fineShare: 0.4,
	side: 0.6,
	up: 0.4,
	dry: 0.6,
} as const;

/**
 * The relief of rinds and raisins: the slope of noise that is finer on rinds, `rind` and `shrivel` times as steep; what is lower than
 * `least` is smooth. Slopes are differences over `step` of a cell.
 */
export const FURROWS = {
	rind: 0.5,
	shrivel: 0.15,
	least: 0.02,
	step: 0.3,
	onRinds: { cells: 13, phase: 41 } as Pattern,
	onRaisins: { cells: 7, phase: 41 } as Pattern,
} as const;

/** Light from all around is kept off by so much where a neighbour is pressed on, and from the grooves between drupelets. */
export const CREVICE = { pressed: 0.55, groove: 0.4 } as const;

/**
 * Of the wax, the share that files have in their colours. The rest is in the sheen: wax scatters at the edge, and programs whose
 * light comes from all sides would turn a dark skin grey if all of it lay on the face.
 */
export const WAX_ON_FACE = 0.4;

/** Where flesh is seen through the skin, it gives this share of the colour, and berries differ less. */
export const FLESH_ON_FACE = 0.6;
