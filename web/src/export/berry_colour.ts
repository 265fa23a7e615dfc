/**
 * The colours of natural berries, vertex by vertex: what a picture of the skin would show, so that any viewer does.
 * How ripe each is and what the sun did to it comes from the core; unevenness and bloom from the look.
 */
import type { BerrySurfaces, Fruit, Grown } from "../models/bunch/grown";
import type { Look, Specimen } from "../specimen/specimen";
import { type BerryTint, berryTint, waxColour } from "./berry_tint";
import { type Colour, clamp, mix, smoothstep } from "./colour";
import { hashFraction, noise } from "./noise";
import { traitOf } from "./traits";

/** The brown of the tip scar and of what is left of the style. */
const SCAR: Colour = [0.09, 0.05, 0.028];
/** From this v on lies the scar; a ring of vertices before, its edge. */
const SCAR_V: Record<Fruit, number> = {
	grape: 0.98,
	currant: 0.915,
	bramble: 1,
	lychee: 0.985,
	longan: 0.985,
	duku: 0.97,
};
const SCAR_EDGE = 0.02;
/** About the pedicel's seat little pigment reaches the skin. */
const SEAT: Colour = [0.05, 0.055, 0.02];
/** Of a wax's depth that looks on it at right angles see; what they see at grazing angles is the material's sheen. */
const WAX_FACE_ON = 1.2;
/** So many different ways in which skins are patchy: more would not be told apart. */
const PATCHWORKS = 32;
/** How many noise cells lie across a berry. */
const PATCHES = 1.7;
/** Pigments absorb, so colours mix as depths do: as logarithms, beside this least light. */
const LEAST_LIGHT = 0.004;

/** What all berries have in common. */
interface Skins {
	look: Look;
	wax: Colour;
	/** Of each vertex of the pattern: how much it is the scar, and the pedicel's seat. */
	scars: Float32Array;
	seats: Float32Array;
}

/** 3 × vertices × berries, linear light, 0 … 1, in the order of `surfaces`. */
export function berryColours(grown: Grown, surfaces: BerrySurfaces, { look }: Specimen): Float32Array {
	const colours = new Float32Array(surfaces.positions.length);
	const vertices = surfaces.uvs.length / 2;
	const scar = SCAR_V[grown.form.fruit];
	const along = Float32Array.from({ length: vertices }, (_, vertex) => surfaces.uvs[2 * vertex + 1]);
	const skins: Skins = {
		look,
		wax: waxColour(look),
		scars: along.map((v) => smoothstep(scar - SCAR_EDGE, scar, v)),
		seats: along.map((v) => 0.7 * (1 - smoothstep(0.03, 0.13, v))),
	};
	const patchworks = Array.from({ length: PATCHWORKS }, (_, seed) => patchwork(surfaces.uvs, seed));
	for (let i = 0; i < grown.berries.count; i++) {
		const patches = patchworks[Math.floor(PATCHWORKS * hashFraction(grown.berries.ids[i], 5))];
		const turned = traitOf(grown.berries, i, "turned");
		const shares = along.map((v, vertex) => turnedAt(turned, v, patches[vertex], look.uneven));
		paint(colours, i * vertices, surfaces, skins, berryTint(grown, i, look), shares, patches);
	}
	return colours;
}

/** Noise over the pattern of vertices, 0 … 1, without a seam. */
function patchwork(uvs: Float32Array, seed: number): Float32Array {
	return Float32Array.from({ length: uvs.length / 2 }, (_, vertex) => {
		const u = uvs[2 * vertex];
		const v = uvs[2 * vertex + 1];
		const girth = PATCHES * 4 * v * (1 - v);
		return noise(girth * wave(u), PATCHES * (2 * v - 1), girth * wave(u + 0.25), seed);
	});
}

/** −1 … 1 … −1 in straight lines as u goes round. */
function wave(u: number): number {
	return Math.abs(4 * (u - Math.floor(u)) - 2) - 1;
}

/** How far the skin of a berry has turned at `v`: from the tip and in patches, unevenly. */
function turnedAt(turned: number, v: number, patch: number, uneven: number): number {
	const width = 0.35 + 0.5 * uneven;
	const late = clamp(0.5 - 0.32 * (2 * v - 1) + 0.75 * uneven * (patch - 0.5));
	return smoothstep(0, 1, (turned * (1 + width) - late) / width);
}

/** Writes the colours of one berry, whose first vertex is `first`. */
function paint(
	colours: Float32Array,
	first: number,
	{ normals, pressed }: BerrySurfaces,
	{ look, wax, scars, seats }: Skins,
	tint: BerryTint,
	turned: Float32Array,
	patches: Float32Array,
): void {
	const unripe = tint.unripe.map((value) => Math.log(value + LEAST_LIGHT));
	const ripe = tint.ripe.map((value) => Math.log(value + LEAST_LIGHT));
	const bloom = look.bloom * tint.bloom;
	for (let vertex = 0; vertex < patches.length; vertex++) {
		const at = 3 * (first + vertex);
		const patch = patches[vertex];
		const scar = scars[vertex];
		const seat = seats[vertex];
		const mottle = 0.86 + 0.28 * mix(0.5, patch, 0.4 + 1.2 * look.uneven);
		const waxed = (1 - scar) * waxAt(bloom, patch, normals[at + 1], pressed[first + vertex] / 255);
		for (let k = 0; k < 3; k++) {
			const skin = mottle * Math.exp(mix(unripe[k], ripe[k], turned[vertex]));
			const seated = mix(skin, 0.75 * skin + SEAT[k], seat);
			colours[at + k] = clamp(mix(mix(seated, SCAR[k], 0.9 * scar), wax[k], waxed));
		}
	}
}

/** The share of the skin that wax hides, seen face on: rubbed off where berries touch, thicker above and in patches. */
function waxAt(bloom: number, patch: number, up: number, pressed: number): number {
	const left = mix(0.12, 1, 1 - smoothstep(0.02, 0.5, pressed));
	const depth = 1.2 * bloom * left * mix(0.35, 1, smoothstep(0.12, 0.75, patch)) * (0.6 + 0.4 * up);
	return 1 - Math.exp(-depth / WAX_FACE_ON);
}
