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
/** How many noise cells lie across a berry. */
const PATCHES = 1.6;

/** What the vertices of one berry have in common. */
interface Skin {
	unripe: Lab;
	ripe: Lab;
	turned: number;
	/** How far turning differs over the berry, 0 … 1. */
	turning: number;
	shrivel: number;
	/** 0 … 1: how thick its wax is. */
	wax: number;
	uneven: number;
	seed: number;
}

/** 3 × vertices × berries, linear light, 0 … 1, in the order of `surfaces`. */
export function berryColours(grown: Grown, surfaces: BerrySurfaces, { look, parameters }: Specimen): Float32Array {
	const colours = new Float32Array(surfaces.positions.length);
	const vertices = surfaces.uvs.length / 2;
	const unripe = labOf(linear(look.unripe));
	const ripe = labOf(linear(look.skin));
	for (let i = 0; i < grown.berries.count; i++) {
		const skin = skinOf(grown, i, unripe, ripe, look, parameters.sunlight);
		paint(colours, surfaces, i * vertices, vertices, skin);
	}
	return colours;
}

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
	return {
		unripe: [unripe[0] * (1 + 0.05 * own * chance(5)), unripe[1], unripe[2] * (1 + 0.1 * own * chance(6))],
		ripe: [
			lightness,
			ripe[1] * chroma + pale * (0.02 * sun + 0.012 * own * chance(2)),
			ripe[2] * chroma + pale * 0.04 * sun + 0.015 * own * chance(3),
		],
		turned,
		turning: 4 * turned * (1 - turned),
		shrivel: traitOf(berries, index, "shrivel"),
		wax: look.bloom * (1 + 0.4 * own * chance(4)),
		uneven: own,
		seed,
	};
}

function paint(colours: Float32Array, surfaces: BerrySurfaces, first: number, count: number, skin: Skin): void {
	const { uvs, normals, pressed } = surfaces;
	for (let vertex = 0; vertex < count; vertex++) {
		const at = 3 * (first + vertex);
		const v = uvs[2 * vertex + 1];
		const [nx, ny, nz] = [normals[at], normals[at + 1], normals[at + 2]];
		const patch = noise(PATCHES * nx + 7, PATCHES * ny + 7, PATCHES * nz + 7, skin.seed);
		const colour = colourOf(skinAt(skin, v, patch));
		const scar = scarShare(v);
		const wax = waxAt(skin, patch, ny, pressed[first + vertex] / 255) * (1 - scar);
		for (let channel = 0; channel < 3; channel++) {
			const marked = colour[channel] * mix(1, SCAR_TINT[channel], scar);
			colours[at + channel] = mix(marked, WAX[channel], wax);
		}
	}
}

/** The skin itself. Red comes before darkness, so half-turned berries are rose; the tip is ahead of the seat. */
function skinAt({ unripe, ripe, turned, turning, shrivel, uneven }: Skin, v: number, patch: number): Lab {
	const ripeness = clamp(turned + turning * (0.25 * (v - 0.5) + 0.7 * uneven * (patch - 0.5)));
	const hue = ripeness * (2 - ripeness);
	const shade = ripeness * mix(ripeness, 1, 0.3);
	const seat = SEAT_LIGHTER * (1 - smoothstep(0, SEAT_V, v));
	const lightness = mix(unripe[0], ripe[0], shade) * (1 + 0.16 * uneven * (patch - 0.5)) + seat;
	const dry = 0.65 * shrivel;
	return [
		mix(lightness, RAISIN[0], dry),
		mix(mix(unripe[1], ripe[1], hue), RAISIN[1], dry),
		mix(mix(unripe[2], ripe[2], hue), RAISIN[2], dry),
	];
}

/** 0 … 1: the share of the skin that wax hides; rubbed off where berries touch, thicker above and in patches. */
function waxAt({ wax, shrivel }: Skin, patch: number, up: number, pressed: number): number {
	return clamp(
		WAX_COVER * wax * (1 - 0.85 * pressed) * (0.55 + 0.9 * patch) * (0.85 + 0.15 * up) * (1 - 0.5 * shrivel),
	);
}
