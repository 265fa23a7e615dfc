import type { Specimen } from "../../specimen/specimen";
import type { OutlinePoint } from "./outline/points";

/** The document of a leaf. */
export interface LeafSpecimen extends Specimen {
	/** Points of the outline (outline/points.ts). */
	outline: OutlinePoint[];
}
