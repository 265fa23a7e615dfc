import type { Colour } from "../../../plant/colour";
import type { Fruit } from "../bunch_plant";

/** Properties of the skin of a kind of fruit, independent of its colour. */
export interface FruitSkin {
	/** 0: taut and glossy, flesh shines through; 1: a dull rind. */
	rind: number;
	/** Colour in the grooves between drupelets or tubercles as a factor on the skin's. */
	grooves: Colour;
	/**
	 * Radial range of grooves: all groove nearer the centre than the first of these (in radii), none beyond the
	 * second.
	 */
	depth: [groove: number, top: number];
	/** 0 … 1: visibility of meridian veins in the flesh, as of currants; 0 for grapes. */
	veins: number;
	/** Value of v from which on the tip's scar or the flower's remains lie; above 1 for none. */
	scar: number;
	/** Factor on the light that the flesh transmits. */
	flesh: number;
	/** 0 … 1: gloss of a clean skin's coat, in files; 0 for rinds. */
	gloss: number;
}

const SMOOTH: FruitSkin = {
	rind: 0,
	grooves: [1, 1, 1],
	depth: [0, 0.01],
	veins: 0,
	scar: 0.98,
	flesh: 1,
	gloss: 0.25,
};
const RIND: FruitSkin = { ...SMOOTH, gloss: 0 };

/** Skins by fruit, estimated by eye. The core supplies the relief. */
export const FRUIT_SKINS: Record<Fruit, FruitSkin> = {
	grape: SMOOTH,
	currant: { ...SMOOTH, veins: 0.6, scar: 0.955, flesh: 1.2, gloss: 0.9 },
	bramble: { ...SMOOTH, grooves: [0.35, 0.2, 0.25], depth: [0.8, 0.95], scar: 1.1, flesh: 0.6, gloss: 0.7 },
	lychee: { ...RIND, rind: 0.75, grooves: [1.5, 2.4, 1.9], depth: [0.955, 1.005], scar: 0.99, flesh: 0.08 },
	longan: { ...RIND, rind: 0.9, scar: 0.99, flesh: 0.08 },
	duku: { ...RIND, rind: 0.8, flesh: 0.12 },
};
