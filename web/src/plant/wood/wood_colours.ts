/** Colours of bark by thickness: that of thin branches is smoother and younger. */
import { type Colour, smoothstep } from "../colour";
import { noise } from "../noise";
import type { PlantMesh } from "../plant";
import type { Wooden } from "./wooden";

export interface Bark {
	readonly old: Colour;
	readonly young: Colour;
	/** The mean of the bark's picture: colours of vertices are multiplied by it. White where absent. */
	readonly mean?: Colour;
	/** Radii in metres between which young bark turns into old. */
	readonly from: number;
	readonly to: number;
	/** The colour of old bark towards the ground, as on a birch. */
	readonly foot?: Colour;
	/** The colour of dead wood without bark. */
	readonly dead?: Colour;
}

/** Number of radii with computed colours; radii between take the next below. */
const CLASSES = 64;

/**
 * Returns colours of the tubes (3 × vertices), by the radius of the segment; without the darkening near the ground for
 * previews, which have little time. Undefined if the plant does not list the segments of its vertices.
 */
export function woodColours(
	{ segments, vertexSegments, deadSegments }: Wooden,
	mesh: PlantMesh,
	bark: Bark,
): Float32Array | undefined {
	if (!vertexSegments || vertexSegments.length !== mesh.positions.length / 3) return undefined;
	const palette = Float32Array.from({ length: 3 * CLASSES }, (_, i) => {
		const share = smoothstep(0, 1, Math.floor(i / 3) / (CLASSES - 1));
		return over(bark.young[i % 3] + share * (bark.old[i % 3] - bark.young[i % 3]), bark.mean?.[i % 3]);
	});
	const under = (colour?: Colour) => colour?.map((channel, k) => over(channel, bark.mean?.[k])) as Colour | undefined;
	const [foot, dead] = [under(bark.foot), under(bark.dead)];
	const range = (CLASSES - 1) / (bark.to - bark.from);
	const places = new Uint8Array(segments.count);
	for (let segment = 0; segment < places.length; segment++) {
		const place = Math.floor((segments.radii[2 * segment + 1] - bark.from) * range);
		places[segment] = 3 * Math.max(0, Math.min(CLASSES - 1, place));
	}
	const colours = new Float32Array(mesh.positions.length);
	for (let vertex = 0, at = 0; vertex < vertexSegments.length; vertex++, at += 3) {
		if (dead && deadSegments?.[vertexSegments[vertex]]) {
			weather(colours, at, mesh.positions, dead);
			continue;
		}
		const place = places[vertexSegments[vertex]];
		colours[at] = palette[place];
		colours[at + 1] = palette[place + 1];
		colours[at + 2] = palette[place + 2];
		if (foot && mesh.sky) darken(colours, at, mesh.positions, foot, place / (3 * (CLASSES - 1)));
	}
	return colours;
}

/** Colours a vertex of dead wood: weathered, lighter and darker in patches. */
function weather(colours: Float32Array, at: number, positions: Float32Array, dead: Colour): void {
	const [x, y, z] = positions.subarray(at, at + 3);
	const light = 0.7 + 0.6 * noise(6 * x, 2 * y, 6 * z);
	for (let k = 0; k < 3; k++) colours[at + k] = Math.min(1, light * dead[k]);
}

/** Returns the colour that a picture of a mean lightness turns into a colour; 1 where it cannot get light enough. */
function over(colour: number, mean = 1): number {
	return Math.min(1, colour / mean);
}

/**
 * Darkens the bark of a vertex near the ground: diamonds as high as wide, which meet below, up to a varying height.
 * @param at index of the vertex's first number
 * @param old how old the bark is there, 0 … 1
 */
function darken(colours: Float32Array, at: number, positions: Float32Array, dark: Colour, old: number): void {
	if (old < 0.25) return;
	const [x, y, z] = positions.subarray(at, at + 3);
	const height = y / (0.8 + 0.8 * noise(2 * x, 0, 2 * z));
	const patch = noise(11 * x, 7 * y, 11 * z) + 0.5 * (noise(23 * x, 15 * y, 23 * z) - 0.5);
	const share = 0.93 * smoothstep(height, height + 0.16, patch) * smoothstep(0.25, 0.6, old);
	for (let k = 0; k < 3; k++) colours[at + k] += share * (dark[k] - colours[at + k]);
}
