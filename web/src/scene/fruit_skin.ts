import type { Fruit } from "../core/grown";
import type { Rgb } from "./colour";

/** How the skin of a kind of fruit is made, whatever its colour. */
export interface FruitSkin {
	/** 0: taut and glossy, flesh shines through; 1: a dull rind. */
	rind: number;
	/** Rows of drupelets or tubercles from pole to pole; 0 for a smooth skin. */
	rows: number;
	/** How high these rise: the tangent of their steepest slope. */
	relief: number;
	/** Colour between the rows' humps as a factor on the skin's. */
	between: Rgb;
	/** 0 … 1: meridian veins seen in the flesh. */
	veins: number;
	/** From this v on lies the tip's scar or what is left of the flower. */
	scar: number;
	/** Factor on how much light the flesh passes. */
	flesh: number;
}

const SMOOTH: FruitSkin = { rind: 0, rows: 0, relief: 0, between: [1, 1, 1], veins: 0.3, scar: 0.965, flesh: 1 };

/** Estimates by eye; the core gives the forms, these only dress them. */
export const FRUIT_SKINS: Record<Fruit, FruitSkin> = {
	grape: SMOOTH,
	currant: { ...SMOOTH, veins: 1, scar: 0.915, flesh: 1.6 },
	bramble: { ...SMOOTH, rows: 0, relief: 0.9, between: [0.3, 0.2, 0.25], veins: 0, scar: 1, flesh: 0.8 },
	lychee: { ...SMOOTH, rind: 0.75, relief: 0.5, between: [1.15, 1.5, 1.3], veins: 0, scar: 0.985, flesh: 0.08 },
	longan: { ...SMOOTH, rind: 0.9, veins: 0, scar: 0.985, flesh: 0.08 },
	duku: { ...SMOOTH, rind: 0.8, veins: 0, scar: 0.97, flesh: 0.12 },
};
