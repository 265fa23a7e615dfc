/**
 * The *wind* form: a plant that sways without end, in plain glTF. Every vertex has two morph targets, its displacement
 * by a sine and by a cosine of time (plant/point_sway.ts); an animation of their weights loops without a seam. Readers
 * without animation show the plant at rest.
 */
import type { Part } from "../plant/part";
import type { Sway } from "../plant/sway";
import type { Wooden } from "../plant/wood/wooden";
import type { About } from "./about";
import { exportGlb } from "./glb";
import { lightParts } from "./light";
import { paletted } from "./palette";
import { WIND_TRIANGLES } from "./plant_files";

const PIXELS = 256;

/**
 * Writes the file.
 * @param sway absent where wind does not move the plant
 * @param triangles the most triangles
 * @param plant the plant of the parts: its wood carries the leaves
 */
export async function windGlb(
	parts: Iterable<Part>,
	about: About,
	sway: Sway | undefined,
	triangles = WIND_TRIANGLES,
	plant?: Wooden,
): Promise<Uint8Array<ArrayBuffer>> {
	const light = paletted(await lightParts(parts, { triangles, pixels: PIXELS, still: sway?.foot, plant }));
	return exportGlb(light, about, sway ? { sway } : {});
}
