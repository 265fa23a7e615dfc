/**
 * Paints organs along their length and width, as the text's `#material` describes them
 * (docs/models/flower/language.md).
 */
import { type Colour, clamp, encoded, linear } from "../../plant/colour";
import type { Picture } from "../../plant/material";

/** FlowerPaint of a material: colours in linear light, lengths as shares of an organ's length and of half its width. */
export interface FlowerPaint {
	/** Colours where an organ begins and ends. */
	base: Colour;
	tip: Colour;
	/** Share of the length over which `base` blends into `tip`. */
	foot: number;
	margin: { colour: Colour; width: number };
	veins: {
		colour: Colour;
		/** Number to a side. */
		count: number;
		strength: number;
		/** Whether veins branch off a rib in the middle. */
		feathered: boolean;
	};
	/** Share of light that is transmitted. */
	light: number;
}

/** Size of a picture in pixels: along an organ, and from its middle to its margin. */
const PICTURE_LENGTH = 256;
const PICTURE_WIDTH = 128;
/** Position at which veins fork, as a share of the length, and how far they part, as a share of their distance. */
const FORK = 0.42;
const FORK_DISTANCE = 0.25;
/** Width of a vein as a share of the distance between two. */
const VEIN_WIDTH = 0.13;
/**
 * Width of a rib as a share of half the width, and how far side veins have moved forward at the margin, as a share of
 * the length.
 */
const RIB = 0.045;
const FORWARD = 0.17;

/** Converts an answer's columns to its materials' paints. */
export function paintsOf(colours: Uint32Array, numbers: Float32Array): FlowerPaint[] {
	return Array.from({ length: colours.length / 4 }, (_, i) => {
		const [base, tip, margin, veins] = [...colours.subarray(4 * i, 4 * i + 4)].map(colourOf);
		const [foot, width, count, strength, light, feathered] = numbers.subarray(6 * i, 6 * i + 6);
		return {
			base,
			tip,
			foot,
			margin: { colour: margin, width },
			veins: { colour: veins, count, strength, feathered: feathered === 1 },
			light,
		};
	});
}

/** Converts 0xrrggbb in sRGB to linear light. */
const colourOf = (packed: number): Colour => linear(packed.toString(16).padStart(6, "0"));

/** Returns whether a paint has details that colours of vertices cannot show. */
export function isFine({ margin, veins }: FlowerPaint): boolean {
	return margin.width > 0 || (veins.count >= 1 && veins.strength > 0);
}

/** Returns the colour at `u` along the organ and `v` from its middle to its margin, both 0 … 1. */
export function colourAt({ base, tip, foot, margin, veins }: FlowerPaint, u: number, v: number): Colour {
	const blended = mixed(base, tip, smooth(u / Math.max(foot, 1e-3)));
	const withMargin =
		margin.width > 0 ? mixed(blended, margin.colour, smooth((v - 1 + margin.width) / margin.width)) : blended;
	const veinDensity = veins.feathered ? featheredVeins : spreadingVeins;
	return veins.count >= 1
		? mixed(withMargin, veins.colour, veins.strength * veinDensity(veins.count, u, v))
		: withMargin;
}

/**
 * Mean vein density before veins fade, and the position along the organ from which on they fade; for spreading and for
 * feathered veins.
 */
const SPREAD = { ink: 0.23, fades: 0.5 };
const FEATHERED = { ink: 0.1, fades: 0.75 };

/**
 * Returns the colour seen from a distance, where veins only darken the colour around them.
 * @param u position along the organ, 0 … 1
 * @param v position from its middle to its margin, 0 … 1
 */
export function colourFromAfar(paint: FlowerPaint, u: number, v: number): Colour {
	const { veins } = paint;
	const plain = colourAt({ ...paint, veins: { ...veins, count: 0 } }, u, v);
	const { ink, fades } = veins.feathered ? FEATHERED : SPREAD;
	const dark = ink * veins.strength * (1 - smooth((u - fades) / (1 - fades)));
	return veins.count >= 1 ? mixed(plain, veins.colour, dark) : plain;
}

/**
 * Returns the vein density, 0 … 1, of spreading veins: one in the middle, others that spread from the foot, fork, and
 * fade before the tip.
 * @param count veins to a side
 * @param u share of the organ's length, 0 at the foot
 * @param v share of half its width, 0 in the middle
 */
function spreadingVeins(count: number, u: number, v: number): number {
	const across = (v * (Math.floor(count) + 0.5)) / (0.55 + 0.45 * Math.sqrt(u));
	const distance = Math.abs(across - Math.round(across));
	const middle = across < 0.5;
	const fork = middle ? 0 : FORK_DISTANCE * smooth((u - FORK) / 0.3);
	const width = VEIN_WIDTH * (middle ? 1.4 : 1) * (1 - 0.6 * u);
	const offset = Math.abs(distance - fork) / width;
	return Math.exp(-offset * offset) * (1 - smooth((u - 0.62) / 0.38)) * (1 - 0.5 * smooth((v - 0.7) / 0.3));
}

/**
 * Returns the vein density, 0 … 1, of feathered veins: a rib that thins towards the tip, and side veins that leave it,
 * bow forward and fade before the margin.
 * @param count side veins to a side
 * @param u share of the organ's length, 0 at the foot
 * @param v share of half its width, 0 in the middle
 */
function featheredVeins(count: number, u: number, v: number): number {
	const rib = v / (RIB * (1 - 0.7 * u));
	const along = (u - FORWARD * v * (1 + 0.5 * v)) * (Math.floor(count) + 0.5);
	const offset = (along - Math.round(along)) / (VEIN_WIDTH * (0.8 - 0.4 * v));
	const sideVein =
		along > 0.4 ? Math.exp(-offset * offset) * (1 - smooth((v - 0.7) / 0.3)) * (1 - smooth((u - 0.8) / 0.2)) : 0;
	return Math.max(Math.exp(-rib * rib), 0.8 * sideVein);
}

/** Smooth step from 0 at 0 to 1 at 1. */
const smooth = (x: number): number => {
	const t = clamp(x);
	return t * t * (3 - 2 * t);
};

/** Interpolates linearly from colour `a` to `b`. */
const mixed = (a: Colour, b: Colour, share: number): Colour =>
	a.map((value, c) => value + (b[c] - value) * share) as Colour;

/** Cache of painted pictures, least recently used first, so that dragging repaints only changed materials. */
const cache = new Map<string, { picture: Picture; mean: Colour }>();
const MAX_CACHED = 32;

/** Returns an organ's picture by u and v with its mean colour. The same paint gives the same object. */
export function pictureOf(paint: FlowerPaint): { picture: Picture; mean: Colour } {
	const key = JSON.stringify({ ...paint, light: 0 });
	const result = cache.get(key) ?? paintPicture(paint);
	cache.delete(key);
	cache.set(key, result);
	const [oldest] = cache.keys();
	if (cache.size > MAX_CACHED) cache.delete(oldest);
	return result;
}

/** Paints LONG × WIDE pixels, sRGB; `mean` is the mean colour, linear. */
function paintPicture(paint: FlowerPaint): { picture: Picture; mean: Colour } {
	const pixels = new Uint8Array(3 * PICTURE_LENGTH * PICTURE_WIDTH);
	const mean: Colour = [0, 0, 0];
	for (let y = 0; y < PICTURE_WIDTH; y++)
		for (let x = 0; x < PICTURE_LENGTH; x++) {
			const colour = colourAt(paint, (x + 0.5) / PICTURE_LENGTH, (y + 0.5) / PICTURE_WIDTH);
			const shown = encoded(colour);
			for (let c = 0; c < 3; c++) {
				pixels[3 * (y * PICTURE_LENGTH + x) + c] = Math.round(255 * clamp(shown[c]));
				mean[c] += colour[c] / (PICTURE_LENGTH * PICTURE_WIDTH);
			}
		}
	return { picture: { width: PICTURE_LENGTH, height: PICTURE_WIDTH, pixels }, mean };
}
