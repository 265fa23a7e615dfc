import { aboutPlant } from "../../../formats/about_plant";
import { exportGlb } from "../../../formats/glb";
import type { Leaf } from "../grown";
import { LEAF } from "../schema";
import type { LeafSpecimen } from "../specimen";
import { type BakeOptions, bakedParts } from "./baked_parts";

/** Writes the simplified leaf with its textures as glTF. */
export async function bakedGlb(
	leaf: Leaf,
	specimen: LeafSpecimen,
	link: string,
	options?: BakeOptions,
): Promise<Uint8Array<ArrayBuffer>> {
	const about = await aboutPlant(LEAF, leaf, specimen, link);
	return exportGlb(bakedParts(leaf, specimen, options), about, { translucent: true });
}
