/**
 * The *wind* form: a plant that sways for ever, in plain glTF. Every vertex has two targets of morphing, where a sine and where a cosine
 * of time take it (plant/swing.ts); an animation of their weights goes round without a seam. What readers play nothing is at rest.
 */
import type { Part } from "../plant/part";
import type { Sway } from "../plant/sway";
import type { About } from "./about";
import { exportGlb } from "./glb";
import { lightParts } from "./light";
import { paletted } from "./palette";
import { WIND_TRIANGLES } from "./plant_files";

const PIXELS = 256;

/** @param sway absent of what stands still: then nothing moves */
export async function windGlb(
	parts: Iterable<Part>,
	about: About,
	sway: Sway | undefined,
	triangles = WIND_TRIANGLES,
): Promise<Uint8Array<ArrayBuffer>> {
	const light = paletted(await lightParts(parts, { triangles, pixels: PIXELS, still: sway?.foot }));
	return exportGlb(light, about, sway ? { sway } : {});
}
