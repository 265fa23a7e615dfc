/** What organs of a material look like along their length and width, as the text's `#material` says (docs/models/flower/language.md). */
import { type Colour, clamp, encoded, linear } from "../../plant/colour";
import type { Picture } from "../../plant/material";

/** Colours in linear light; shares of an organ's length and of half its width. */
export interface Paint {
	/** Where an organ begins and where it ends. */
	base: Colour;
	tip: Colour;
	/** Over how much of its length the one goes into the other. */
	foot: number;
	margin: { colour: Colour; width: number };
	veins: {
		colour: Colour;
		/** A side. */
		count: number;
		strength: number;
		/** They leave one in the middle. */
		feathered: boolean;
	};
	/** Light that comes through from behind, as a share. */
	light: number;
}

/** Pixels along an organ, and from its middle to its margin. */
const LONG = 256;
const WIDE = 128;
/** Veins fork here, so far along, and part by this share of the room between two. */
const FORK = 0.42;
const PARTED = 0.25;
/** How wide a vein is, as a share of the room between two. */
const THIN = 0.13;
/** How wide a rib is, as a share of half the width, and how far forward its side veins have gone at the margin, of the length. */
const RIB = 0.045;
const FORWARD = 0.17;

/** Columns of an answer → what its materials are painted with. */
export function paintsOf(colours: Uint32Array, numbers: Float32Array): Paint[] {
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

/** Whether there is something that a colour for each vertex is too coarse for. */
export function isFine({ margin, veins }: Paint): boolean {
	return margin.width > 0 || (veins.count >= 1 && veins.strength > 0);
}

/** The colour at a place: u along the organ, v from its middle to its margin, both 0 … 1. */
export function colourAt({ base, tip, foot, margin, veins }: Paint, u: number, v: number): Colour {
	const along = mixed(base, tip, smooth(u / Math.max(foot, 1e-3)));
	const edged = margin.width > 0 ? mixed(along, margin.colour, smooth((v - 1 + margin.width) / margin.width)) : along;
	const drawn = veins.feathered ? barbs : ink;
	return veins.count >= 1 ? mixed(edged, veins.colour, veins.strength * drawn(veins.count, u, v)) : edged;
}

/** What ink comes to on the average before it fades, and from where along the organ it does: of veins that spread, and of feathered ones. */
const SPREAD = { ink: 0.23, fades: 0.5 };
const FEATHERED = { ink: 0.1, fades: 0.75 };

/** The same where single veins cannot be told any more: what they do to the colour about them. */
export function colourFromAfar(paint: Paint, u: number, v: number): Colour {
	const { veins } = paint;
	const plain = colourAt({ ...paint, veins: { ...veins, count: 0 } }, u, v);
	const { ink, fades } = veins.feathered ? FEATHERED : SPREAD;
	const dark = ink * veins.strength * (1 - smooth((u - fades) / (1 - fades)));
	return veins.count >= 1 ? mixed(plain, veins.colour, dark) : plain;
}

/** How much of a place is vein: one in the middle, others that spread from the foot, fork, and fade before the tip. */
function ink(count: number, u: number, v: number): number {
	const across = (v * (Math.floor(count) + 0.5)) / (0.55 + 0.45 * Math.sqrt(u));
	const from = Math.abs(across - Math.round(across));
	const middle = across < 0.5;
	const apart = middle ? 0 : PARTED * smooth((u - FORK) / 0.3);
	const wide = THIN * (middle ? 1.4 : 1) * (1 - 0.6 * u);
	const off = Math.abs(from - apart) / wide;
	return Math.exp(-off * off) * (1 - smooth((u - 0.62) / 0.38)) * (1 - 0.5 * smooth((v - 0.7) / 0.3));
}

/** Of a feathered one: a rib that thins towards the tip, and side veins that leave it, bow forward and fade before the margin. */
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

/** Pictures that have been painted, those used last at the end: what is dragged is painted once. */
const painted = new Map<string, { picture: Picture; mean: Colour }>();
const MOST = 32;

/** An organ's face by u and v, and its mean colour. The same paint gives the same object. */
export function pictureOf(paint: Paint): { picture: Picture; mean: Colour } {
	const key = JSON.stringify({ ...paint, light: 0 });
	const made = painted.get(key) ?? paintedOf(paint);
	painted.delete(key);
	painted.set(key, made);
	const [oldest] = painted.keys();
	if (painted.size > MOST) painted.delete(oldest);
	return made;
}

function paintedOf(paint: Paint): { picture: Picture; mean: Colour } {
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
