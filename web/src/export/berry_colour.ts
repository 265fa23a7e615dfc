/**
 * The colours of natural berries, vertex by vertex: what a picture of the skin would show, so that any viewer does.
 * How ripe each is and what the sun did to it comes from the core; unevenness and bloom from the look.
 */
import type { BerrySurfaces, Grown } from "../core/grown";
import type { Specimen } from "../specimen/specimen";
import { type Colour, clamp, colourOf, type Lab, labOf, linear, mix, smoothstep } from "./colour";
import { SCAR_TINT } from "./materials";
import { hashFraction, noise } from "./noise";
import { scarShare } from "./scar";
import { traitOf } from "./traits";

/** Wax crystals scatter a little more blue than red; where they lie thickest this is what is seen. */
const WAX: Colour = [0.34, 0.38, 0.46];
/** The thickest wax hides this share of the skin. */
const WAX_COVER = 0.42;
/** Dried skins end here, whatever they were. */
const RAISIN: Lab = labOf(linear("4a2f26"));
/** About the pedicel's seat the skin is paler, as little pigment reaches it. */
const SEAT_V = 0.06;
const SEAT_LIGHTER = 0.07;
/** So many different ways in which skins are patchy: more would not be told apart. */
const PATCHWORKS = 32;
/** How many noise cells lie across a berry. */
const PATCHES = 1.6;

/** How far redder than either end half-turned skins are that end red, in Oklab's a and b. */
const BLUSH = [0.1, 0.03] as const;

/** What the vertices of one berry have in common. */
interface Skin {
	unripe: Lab;
	/** What the way from unripe to ripe bends towards. */
	turningTo: Lab;
	ripe: Lab;
	turned: number;
	/** How far turning differs over the berry, 0 … 1. */
	turning: number;
	shrivel: number;
	/** 0 … 1: how thick its wax is. */
	wax: number;
	uneven: number;
}

/** 3 × vertices × berries, linear light, 0 … 1, in the order of `surfaces`. */
export function berryColours(grown: Grown, surfaces: BerrySurfaces, { look, parameters }: Specimen): Float32Array {
	const colours = new Float32Array(surfaces.positions.length);
	const vertices = surfaces.uvs.length / 2;
	const unripe = labOf(linear(look.unripe));
	const ripe = labOf(linear(look.skin));
	const patchworks = Array.from({ length: PATCHWORKS }, (_, seed) => patchwork(surfaces.uvs, seed));
	for (let i = 0; i < grown.berries.count; i++) {
		const skin = skinOf(grown, i, unripe, ripe, look, parameters.sunlight);
		const patches = patchworks[Math.floor(PATCHWORKS * hashFraction(grown.berries.ids[i], 7))];
		paint(colours, surfaces, i * vertices, patches, skin);
	}
	return colours;
}

/** How berry `index` differs from the bunch's colours. */
function skinOf(
	{ berries }: Grown,
	index: number,
	unripe: Lab,
	ripe: Lab,
	look: Specimen["look"],
	sunlight: number,
): Skin {
	const seed = berries.ids[index];
	// −1 … 1, mostly near 0.
	const chance = (stream: number) => hashFraction(seed, stream) + hashFraction(seed, stream + 16) - 1;
	const own = look.uneven;
	const sun = sunlight * (traitOf(berries, index, "exposure") - 0.5);
	// Sun gilds pale skins and deepens dark ones.
	const pale = smoothstep(0.45, 0.7, ripe[0]);
	const chroma = 1 + 0.12 * own * chance(1);
	const lightness = ripe[0] * (1 + 0.09 * own * chance(0)) + mix(-0.06, 0.02, pale) * sun;
	const turned = traitOf(berries, index, "turned");
	const start: Lab = [unripe[0] * (1 + 0.05 * own * chance(5)), unripe[1], unripe[2] * (1 + 0.1 * own * chance(6))];
	const end: Lab = [
		lightness,
		ripe[1] * chroma + pale * (0.02 * sun + 0.012 * own * chance(2)),
		ripe[2] * chroma + pale * 0.04 * sun + 0.015 * own * chance(3),
	];
	return {
		unripe: start,
		turningTo: blushing(start, end),
		ripe: end,
		turned,
		turning: 4 * turned * (1 - turned),
		shrivel: traitOf(berries, index, "shrivel"),
		wax: look.bloom * (1 + 0.4 * own * chance(4)),
		uneven: own,
	};
}

/** The first pigments are red, while the skin is still pale: skins that end red or blue are rose in between. */
function blushing(unripe: Lab, ripe: Lab): Lab {
	const red = smoothstep(-0.01, 0.03, ripe[1]);
	return [
		mix(unripe[0], ripe[0], mix(0.5, 0.35, red)),
		mix(mix(unripe[1], ripe[1], 0.5), Math.max(unripe[1], ripe[1]) + BLUSH[0], red),
		mix(unripe[2], ripe[2], 0.5) + BLUSH[1] * red,
	];
}

/** Noise over the pattern of vertices, 0 … 1, without a seam. */
function patchwork(uvs: Float32Array, seed: number): Float32Array {
	return Float32Array.from({ length: uvs.length / 2 }, (_, vertex) => {
		const [u, v] = [uvs[2 * vertex], uvs[2 * vertex + 1]];
		const girth = PATCHES * 4 * v * (1 - v);
		return noise(girth * wave(u), PATCHES * (2 * v - 1), girth * wave(u + 0.25), seed);
	});
}

/** −1 … 1 … −1 in straight lines as u goes round. */
function wave(u: number): number {
	return Math.abs(4 * (u - Math.floor(u)) - 2) - 1;
}

function paint(colours: Float32Array, surfaces: BerrySurfaces, first: number, patches: Float32Array, skin: Skin): void {
	const { uvs, normals, pressed } = surfaces;
	for (let vertex = 0; vertex < patches.length; vertex++) {
		const at = 3 * (first + vertex);
		const v = uvs[2 * vertex + 1];
		const patch = patches[vertex];
		const colour = colourOf(skinAt(skin, v, patch));
		const scar = scarShare(v);
		const wax = waxAt(skin, patch, normals[at + 1], pressed[first + vertex] / 255) * (1 - scar);
		for (let channel = 0; channel < 3; channel++) {
			const marked = colour[channel] * mix(1, SCAR_TINT[channel], scar);
			colours[at + channel] = mix(marked, WAX[channel], wax);
		}
	}
}

/** The skin itself; its tip turns before its seat. */
function skinAt(skin: Skin, v: number, patch: number): Lab {
	const { unripe, turningTo, ripe, turned, turning, shrivel, uneven } = skin;
	const ripeness = clamp(turned + turning * (0.25 * (v - 0.5) + 0.7 * uneven * (patch - 0.5)));
	const seat = SEAT_LIGHTER * (1 - smoothstep(0, SEAT_V, v));
	const lightness = bent(unripe[0], turningTo[0], ripe[0], ripeness) * (1 + 0.16 * uneven * (patch - 0.5)) + seat;
	const dry = 0.65 * shrivel;
	return [
		mix(lightness, RAISIN[0], dry),
		mix(bent(unripe[1], turningTo[1], ripe[1], ripeness), RAISIN[1], dry),
		mix(bent(unripe[2], turningTo[2], ripe[2], ripeness), RAISIN[2], dry),
	];
}

/** From one value to another by way of a third, a quadratic Bézier curve's. */
function bent(from: number, by: number, to: number, share: number): number {
	return mix(mix(from, by, share), mix(by, to, share), share);
}

/** 0 … 1: the share of the skin that wax hides; rubbed off where berries touch, thicker above and in patches. */
function waxAt({ wax, shrivel }: Skin, patch: number, up: number, pressed: number): number {
	return clamp(
		WAX_COVER * wax * (1 - 0.85 * pressed) * (0.55 + 0.9 * patch) * (0.85 + 0.15 * up) * (1 - 0.5 * shrivel),
	);
}
