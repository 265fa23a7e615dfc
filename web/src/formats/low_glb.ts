/**
 * The *low* form: a limited number of triangles, in plain glTF, which opens everywhere. Colours are pictures: game
 * engines and simple readers drop vertex colours, or read them as sRGB.
 */
import type { Part } from "../plant/part";
import type { Wooden } from "../plant/wood/wooden";
import type { About } from "./about";
import { exportGlb } from "./glb";
import { lightParts } from "./light";
import { paletted } from "./palette";
import { LOW_TRIANGLES } from "./plant_files";

const PIXELS = 256;

/**
 * Writes the file.
 * @param triangles the most triangles
 * @param plant the plant of the parts: its wood carries the leaves
 */
export async function lowGlb(
	parts: Iterable<Part>,
	about: About,
	triangles = LOW_TRIANGLES,
	plant?: Wooden,
): Promise<Uint8Array<ArrayBuffer>> {
	return exportGlb(paletted(await lightParts(parts, { triangles, pixels: PIXELS, plant })), about);
}
