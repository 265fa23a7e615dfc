/**
 * Rules of a berry's skin colour at a point: numbers shared by the view's shaders (render/berry_shader.ts), per pixel,
 * and the files' colours (berry_colour.ts), per vertex. Estimates by eye.
 */
import type { Colour } from "../../../plant/colour";

/** Noise: cells per berry radius, and the offset between berries per unit of their phase. */
export interface Pattern {
	readonly cells: number;
	readonly phase: number;
}

/** Noise that vertices can show, and finer noise. */
export const COARSE: Pattern = { cells: 1.7, phase: 61 };
export const FINE: Pattern = { cells: 9, phase: 23 };

/** Least light of a colour: colours mix as pigment depths, as logarithms. */
export const LEAST_LIGHT = 0.004;

/**
 * Turning starts at the tip (`along` the axis, −1 at the seat … 1) and in patches (`coarse`, `fine` noise), and
 * crosses a berry over a `width`; an `uneven` look widens it and makes patches.
 */
export const TURNING = { width: 0.35, uneven: 0.5, along: 0.32, coarse: 0.75, fine: 0.3 } as const;

/** Mottling: the factor on the colour goes from `least` by `span` with a share of the coarse noise. */
export const MOTTLE = { least: 0.86, span: 0.28, share: 0.4, uneven: 1.2 } as const;

/** Around the pedicel's seat, up to v = `to`, the skin has little pigment. */
export const SEAT = { from: 0.03, to: 0.13, share: 0.7, skin: 0.75, colour: [0.05, 0.055, 0.02] as Colour } as const;

/** Corky brown of the tip scar and the style's remains, mixed with the skin; its edge has this width in v. */
export const SCAR = { edge: 0.016, share: 0.72, skin: 0.25, colour: [0.17, 0.105, 0.055] as Colour } as const;

/** Paler skin before the scar, over a `width` in v. */
export const HALO = { width: 0.06, end: 0.005, share: 0.4, skin: 1.2, light: 0.01 } as const;

/**
 * Pale ripe skins turn amber in the sun: from `from` to `to` of the cosine to the sun's direction, shifted by coarse
 * noise, to `colour` times their own.
 */
export const AMBER = { from: 0.05, to: 1.05, coarse: 0.7, colour: [1.0, 0.77, 0.34] as Colour } as const;

/** Absorption that drying adds to flesh, per radius: raisins of pale grapes are amber, then brown. */
export const BROWNED: Colour = [0.45, 0.8, 1.25];

/**
 * Light among clear berries also passes through neighbours and so grows warm: the albedo tends to its root times this,
 * the more the clearer the berries.
 */
export const AMONG_CLEAR: Colour = [1, 0.88, 0.6];

/**
 * Blotches of a rind: the factor goes from `least` by `span` with the fine noise. Rinds above `from` have a relief.
 */
export const RIND = { least: 0.72, span: 0.45, from: 0.1 } as const;

/**
 * Wax is thinner below and in patches, is rubbed off where berries touch or are brushed, and disappears as a berry
 * dries. Seen at `facing` (the cosine to the normal) it hides 1 − exp(−depth / (grazing + facing)) of the skin.
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
 * Relief of rinds and raisins: slopes of noise, finer on rinds, `rind` and `shrivel` times as steep; below `least` the
 * skin is smooth. Slopes are differences over `step` of a cell.
 */
export const FURROWS = {
	rind: 0.5,
	shrivel: 0.15,
	least: 0.02,
	step: 0.3,
	onRinds: { cells: 13, phase: 41 } as Pattern,
	onRaisins: { cells: 7, phase: 41 } as Pattern,
} as const;

/** Ambient light blocked at contacts with neighbours, and in grooves between drupelets. */
export const CREVICE = { pressed: 0.55, groove: 0.4 } as const;

/**
 * Share of the wax in files' colours. The rest is sheen: under ambient light from all sides, a dark skin would turn
 * grey if all wax were in the colour.
 */
export const WAX_ON_FACE = 0.4;

/** Share of the flesh in the colour where it is visible through the skin; berries then differ less. */
export const FLESH_ON_FACE = 0.6;
