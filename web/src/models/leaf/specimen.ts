import type { Specimen } from "../../specimen/specimen";
import type { OutlinePoint } from "./outline/points";

/** The document of a leaf. */
export interface LeafSpecimen extends Specimen {
	/** The outline's points, as outline/points.ts has them. */
	outline: OutlinePoint[];
}
