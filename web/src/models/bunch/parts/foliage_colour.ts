/** Colours of leaves, petioles, cane and stamens, vertex by vertex, for view and files. */
import { type Colour, linear, mix, smoothstep } from "../../../plant/colour";
import { noise } from "../../../plant/noise";
import type { Berries, Foliage, FoliagePart } from "../bunch_plant";
import { meanOf } from "../traits";

/** Colours of a leaf's faces and veins, in summer and in autumn. */
export const LEAF = {
	upper: linear("476a2e"),
	lower: linear("7f9a63"),
	vein: linear("b6c27e"),
	late: [0.42, 0.27, 0.045] as Colour,
	lateVein: [0.75, 0.6, 0.16] as Colour,
} as const;
/** Shares of autumn between which a leaf turns. */
export const AUTUMN = [0.55, 0.95] as const;
export const PETIOLE = linear("8c8f4a");
/** Colour of a one-year-old cane's bark. */
export const CANE = linear("7a5a3c");
/**
 * Colours of a flower's parts, each up to a value of v: green parts, filaments, anthers, petals
 * (models/bunch/berry/flower.hpp).
 */
export const FLOWER = [
	{ to: 0.25, colour: linear("b6c67e") },
	{ to: 0.5, colour: linear("eef1da") },
	{ to: 0.75, colour: linear("efe8c0") },
	{ to: 1, colour: linear("f3e9ee") },
] as const;

/** Noise cells per metre, of broad patches and of mottling. */
const BROAD = 45;
const MOTTLE = 260;
/** Noise cells of the cracks along one-year-old bark: to one turn of u, to one of v. */
const CRACKS = [26, 1.6] as const;
/** Position in a blade's texture that stays green longest. */
const GREENEST = [0.5, 0.62] as const;
/** Brightest factor on the colours of green blades, and of turned ones. */
const BRIGHTEST = [1.25, 1.2] as const;

/** Number of autumn shades: a leaf's texture is painted once per shade, not at every moment of an animation. */
const SHADES = 50;

/** Returns the colours of a flower's mesh or of a piece of it: 3 × vertices, linear light. */
export function flowerColours(uvs: Float32Array): Float32Array {
	const colours = new Float32Array(1.5 * uvs.length);
	for (let vertex = 0; vertex < uvs.length / 2; vertex++) {
		const v = uvs[2 * vertex + 1];
		colours.set((FLOWER.find(({ to }) => v < to) ?? FLOWER[FLOWER.length - 1]).colour, 3 * vertex);
	}
	return colours;
}

/** Returns how far leaves have turned, 0 … 1: they turn as berries dry. */
export function autumnOf(berries: Berries): number {
	return Math.round(SHADES * meanOf(berries, "shrivel", 0)) / SHADES;
}

/**
 * Returns the brightest colour of a leaf between its veins: its texture has it, and vertices darken it.
 * @param autumn 0 … 1: how far leaves have turned
 */
export function brightestLeaf(autumn: number): Colour {
	const turned = smoothstep(AUTUMN[0] - 0.25, AUTUMN[0] + 0.1, autumn);
	return LEAF.upper.map((value, k) => Math.max(BRIGHTEST[0] * value, BRIGHTEST[1] * turned * LEAF.late[k])) as Colour;
}

/**
 * Returns the colours of the foliage's vertices: 3 × vertices, linear light; for leaves with veins as shares of the
 * brightest colour, which their texture has.
 * @param autumn 0 … 1: how far leaves have turned
 */
export function foliageColours({ positions, uvs, parts, veins }: Foliage, autumn: number): Float32Array {
	const brightest = brightestLeaf(autumn);
	const colours = new Float32Array(positions.length);
	for (const { kind, firstVertex, vertexCount } of parts) {
		for (let vertex = firstVertex; vertex < firstVertex + vertexCount; vertex++) {
			const [x, y, z] = positions.subarray(3 * vertex, 3 * vertex + 3);
			const vertexLook: VertexLook = {
				broad: noise(BROAD * x, BROAD * y, BROAD * z),
				mottle: noise(MOTTLE * x, MOTTLE * y, MOTTLE * z),
				u: uvs[2 * vertex],
				v: uvs[2 * vertex + 1],
			};
			const colour = COLOURS[kind](vertexLook, autumn);
			const shares = kind === "leaf" && veins ? colour.map((value, k) => Math.min(1, value / brightest[k])) : colour;
			colours.set(shares, 3 * vertex);
		}
	}
	return colours;
}

/** Noise, 0 … 1, and texture coordinates of a vertex. */
interface VertexLook {
	broad: number;
	mottle: number;
	u: number;
	v: number;
}

/** Colours at a vertex by kind of part; `autumn` is as in `foliageColours`. */
const COLOURS: Record<FoliagePart["kind"], (vertexLook: VertexLook, autumn: number) => Colour> = {
	leaf({ broad, mottle, u, v }, autumn) {
		const away = Math.hypot(u - GREENEST[0], v - GREENEST[1]);
		const turned = smoothstep(AUTUMN[0], AUTUMN[1], autumn * (0.6 + 0.5 * broad + 0.5 * away));
		const green = 0.8 + 0.3 * broad + 0.15 * mottle;
		const late = 0.7 + 0.5 * mottle;
		return LEAF.upper.map((value, k) => mix(value * green, LEAF.late[k] * late, turned)) as Colour;
	},
	petiole: ({ mottle }) => scaled(PETIOLE, 0.85 + 0.3 * mottle),
	cane({ broad, mottle, u, v }) {
		const crack = noise(CRACKS[0] * u, CRACKS[1] * v, broad);
		return scaled(CANE, (0.55 + 0.75 * crack) * (0.85 + 0.3 * mottle));
	},
};

/** Multiplies a colour by a factor. */
function scaled(colour: Colour, factor: number): Colour {
	return colour.map((value) => value * factor) as Colour;
}
