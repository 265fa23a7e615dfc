/** The *low* form: no more triangles than asked for, in plain glTF, which opens everywhere. */
import type { Part } from "../plant/part";
import type { About } from "./about";
import { exportGlb } from "./glb";
import { lightParts } from "./light";
import { LOW_TRIANGLES } from "./plant_files";

const PIXELS = 256;

export async function lowGlb(
	parts: Iterable<Part>,
	about: About,
	triangles = LOW_TRIANGLES,
): Promise<Uint8Array<ArrayBuffer>> {
	return exportGlb(await lightParts(parts, { triangles, pixels: PIXELS }), about);
}
