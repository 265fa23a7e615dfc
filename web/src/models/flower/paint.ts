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
const LONG = 256;
const WIDE = 128;
/** Position at which veins fork, as a share of the length, and how far they part, as a share of their distance. */
const FORK = 0.42;
const PARTED = 0.25;
/** Width of a vein as a share of the distance between two. */
const THIN = 0.13;
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

const colourOf = (packed: number): Colour => linear(packed.toString(16).padStart(6, "0"));

/** Returns whether a paint has details that colours of vertices cannot show. */
export function isFine({ margin, veins }: FlowerPaint): boolean {
	return margin.width > 0 || (veins.count >= 1 && veins.strength > 0);
}

/** Returns the colour at `u` along the organ and `v` from its middle to its margin, both 0 … 1. */
export function colourAt({ base, tip, foot, margin, veins }: FlowerPaint, u: number, v: number): Colour {
	const along = mixed(base, tip, smooth(u / Math.max(foot, 1e-3)));
	const edged = margin.width > 0 ? mixed(along, margin.colour, smooth((v - 1 + margin.width) / margin.width)) : along;
	const drawn = veins.feathered ? barbs : ink;
	return veins.count >= 1 ? mixed(edged, veins.colour, veins.strength * drawn(veins.count, u, v)) : edged;
}

/**
 * Mean vein density before veins fade, and the position along the organ from which on they fade; for spreading and for
 * feathered veins.
 */
const SPREAD = { ink: 0.23, fades: 0.5 };
const FEATHERED = { ink: 0.1, fades: 0.75 };

/** Returns the colour seen from a distance, where veins only darken the colour around them. */
export function colourFromAfar(paint: FlowerPaint, u: number, v: number): Colour {
	const { veins } = paint;
	const plain = colourAt({ ...paint, veins: { ...veins, count: 0 } }, u, v);
	const { ink, fades } = veins.feathered ? FEATHERED : SPREAD;
	const dark = ink * veins.strength * (1 - smooth((u - fades) / (1 - fades)));
	return veins.count >= 1 ? mixed(plain, veins.colour, dark) : plain;
}

/**
 * Vein density of spreading veins: one in the middle, others that spread from the foot, fork, and fade before the tip.
 */
function ink(count: number, u: number, v: number): number {
	const across = (v * (Math.floor(count) + 0.5)) / (0.55 + 0.45 * Math.sqrt(u));
	const from = Math.abs(across - Math.round(across));
	const middle = across < 0.5;
	const apart = middle ? 0 : PARTED * smooth((u - FORK) / 0.3);
	const wide = THIN * (middle ? 1.4 : 1) * (1 - 0.6 * u);
	const off = Math.abs(from - apart) / wide;
	return Math.exp(-off * off) * (1 - smooth((u - 0.62) / 0.38)) * (1 - 0.5 * smooth((v - 0.7) / 0.3));
}

/**
 * Vein density of feathered veins: a rib that thins towards the tip, and side veins that leave it, bow forward and
 * fade before the margin.
 */
function barbs(count: number, u: number, v: number): number {
	const rib = v / (RIB * (1 - 0.7 * u));
	const along = (u - FORWARD * v * (1 + 0.5 * v)) * (Math.floor(count) + 0.5);
	const off = (along - Math.round(along)) / (THIN * (0.8 - 0.4 * v));
	const side = along > 0.4 ? Math.exp(-off * off) * (1 - smooth((v - 0.7) / 0.3)) * (1 - smooth((u - 0.8) / 0.2)) : 0;
	return Math.max(Math.exp(-rib * rib), 0.8 * side);
}

const smooth = (x: number): number => {
	const t = clamp(x);
	return t * t * (3 - 2 * t);
};

const mixed = (a: Colour, b: Colour, share: number): Colour =>
	a.map((value, c) => value + (b[c] - value) * share) as Colour;

/** Cache of painted pictures, least recently used first, so that dragging repaints only changed materials. */
const painted = new Map<string, { picture: Picture; mean: Colour }>();
const MOST = 32;

/** Returns an organ's picture by u and v with its mean colour. The same paint gives the same object. */
export function pictureOf(paint: FlowerPaint): { picture: Picture; mean: Colour } {
	const key = JSON.stringify({ ...paint, light: 0 });
	const made = painted.get(key) ?? paintedOf(paint);
	painted.delete(key);
	painted.set(key, made);
	const [oldest] = painted.keys();
	if (painted.size > MOST) painted.delete(oldest);
	return made;
}

function paintedOf(paint: FlowerPaint): { picture: Picture; mean: Colour } {
	const pixels = new Uint8Array(3 * LONG * WIDE);
	const mean: Colour = [0, 0, 0];
	for (let y = 0; y < WIDE; y++)
		for (let x = 0; x < LONG; x++) {
			const colour = colourAt(paint, (x + 0.5) / LONG, (y + 0.5) / WIDE);
			const shown = encoded(colour);
			for (let c = 0; c < 3; c++) {
				pixels[3 * (y * LONG + x) + c] = Math.round(255 * clamp(shown[c]));
				mean[c] += colour[c] / (LONG * WIDE);
			}
		}
	return { picture: { width: LONG, height: WIDE, pixels }, mean };
}
