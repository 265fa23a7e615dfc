/**
 * Bark as a picture that multiplies the wood's colours; it repeats once around the stem, and along it at the same
 * length, without visible seams.
 */
import { clamp, smoothstep } from "../colour";
import type { Picture } from "../material";
import { hashFraction } from "../noise";

/**
 * furrowed: long ridges that part and meet (oak, most trees). paper: pale, with lenticels across and rough dark patches
 * (birch). ringed: shallow creases across (carrot). fibrous: fine streaks along (roots, cypress, vine). smooth: hardly
 * anything (beech). plated: plates between deep cracks (pine). banded: smooth, with rows of lenticels across (cherry).
 */
export type BarkKind = "furrowed" | "paper" | "ringed" | "fibrous" | "smooth" | "plated" | "banded";

const SIDE = 256;

const made = new Map<BarkKind, Picture>();

/** Returns the picture of a kind of bark, painted on first use. */
export function barkPicture(kind: BarkKind): Picture {
	const known = made.get(kind) ?? painted(SHADES[kind]);
	made.set(kind, known);
	return known;
}

/**
 * Paints SIDE × SIDE pixels in grey.
 * @param shade returns 0 … 1 at a point of the picture, u around the stem and v along it, each 0 … 1
 */
function painted(shade: (u: number, v: number) => number): Picture {
	const pixels = new Uint8Array(3 * SIDE * SIDE);
	for (let row = 0, at = 0; row < SIDE; row++) {
		for (let column = 0; column < SIDE; column++, at += 3) {
			const value = Math.round(255 * clamp(shade((column + 0.5) / SIDE, (row + 0.5) / SIDE)));
			pixels.fill(value, at, at + 3);
		}
	}
	return { width: SIDE, height: SIDE, pixels };
}

/** Steepness of the relief: the height from black to white, in sides of the picture. */
const STEEP: Readonly<Record<BarkKind, number>> = {
	furrowed: 0.05,
	paper: 0.012,
	ringed: 0.012,
	fibrous: 0.03,
	smooth: 0.008,
	plated: 0.05,
	banded: 0.015,
};

const reliefs = new Map<BarkKind, Picture>();

/** Returns the bark as normals (plant/material.ts), in which dark pixels are deep; computed on first use. */
export function barkRelief(kind: BarkKind): Picture {
	const known = reliefs.get(kind) ?? raised(barkPicture(kind), STEEP[kind]);
	reliefs.set(kind, known);
	return known;
}

/**
 * Returns the normal map of a picture's relief, by central differences; the picture repeats at its edges.
 * @param steep height from black to white, in sides of the picture
 */
function raised({ pixels }: Picture, steep: number): Picture {
	const height = (column: number, row: number) => pixels[3 * (SIDE * wrapped(row, SIDE) + wrapped(column, SIDE))] / 255;
	const normals = new Uint8Array(3 * SIDE * SIDE);
	for (let row = 0, at = 0; row < SIDE; row++) {
		for (let column = 0; column < SIDE; column++, at += 3) {
			const x = 0.5 * steep * SIDE * (height(column - 1, row) - height(column + 1, row));
			const y = 0.5 * steep * SIDE * (height(column, row + 1) - height(column, row - 1));
			const length = Math.hypot(x, y, 1);
			normals[at] = Math.round(127.5 + (127.5 * x) / length);
			normals[at + 1] = Math.round(127.5 + (127.5 * y) / length);
			normals[at + 2] = Math.round(127.5 + 127.5 / length);
		}
	}
	return { width: SIDE, height: SIDE, pixels: normals };
}

/** Lightness by kind at a point, 1 for the wood's own colour; in sRGB. */
const SHADES: Readonly<Record<BarkKind, (u: number, v: number) => number>> = {
	/** Bark with deep furrows along the stem, such as an oak's. */
	furrowed(u, v) {
		const drawn = u + 0.035 * (tiled(3 * u, 4 * v, 3, 4, 1) - 0.5);
		const broad = ridge(tiled(14 * drawn, 3 * v, 14, 3, 2));
		const fine = ridge(tiled(34 * drawn, 9 * v, 34, 9, 3));
		const cracks = smoothstep(0.06, 0.3, ridge(tiled(9 * u, 14 * v, 9, 14, 4)));
		const plates = tiled(20 * u, 24 * v, 20, 24, 5);
		return (0.58 + 0.4 * smoothstep(0.02, 0.42, broad) + 0.14 * fine) * (0.88 + 0.12 * cracks) * (0.9 + 0.14 * plates);
	},
	/** Papery bark with lenticels across and split patches, such as a birch's. */
	paper(u, v) {
		const cloud = tiled(4 * u, 6 * v, 4, 6, 11);
		const lenticels = smoothstep(0.77, 0.84, tiled(9 * u, 52 * v, 9, 52, 12));
		// Split bark: patches wider than high, with frayed edges.
		const rough = 0.25 * (tiled(24 * u, 30 * v, 24, 30, 13) - 0.5);
		const split = smoothstep(0.74, 0.82, tiled(3 * u, 6 * v, 3, 6, 14) + rough);
		return (0.9 + 0.1 * cloud) * (1 - 0.5 * lenticels * (0.5 + cloud)) * (1 - 0.82 * split);
	},
	/** Bark with creases around the stem that are interrupted. */
	ringed(u, v) {
		const wave = v + 0.012 * (tiled(4 * u, 3 * v, 4, 3, 21) - 0.5);
		const crease = smoothstep(0.1, 0, ridge(tiled(3 * u, 22 * wave, 3, 22, 22)));
		const reach = smoothstep(0.35, 0.75, tiled(5 * u, 9 * v, 5, 9, 23));
		return 0.94 + 0.06 * tiled(8 * u, 5 * v, 8, 5, 24) - 0.2 * crease * reach;
	},
	/** Bark with streaks along the stem and knobs. */
	fibrous(u, v) {
		const streaks = tiled(22 * u, 3 * v, 22, 3, 31);
		const knobs = tiled(9 * u, 12 * v, 9, 12, 32);
		return 0.72 + 0.2 * streaks + 0.12 * knobs;
	},
	/** Almost smooth bark with eyes, such as a beech's. */
	smooth(u, v) {
		const cloud = tiled(3 * u, 5 * v, 3, 5, 41);
		const grain = tiled(26 * u, 40 * v, 26, 40, 42);
		const eyes = smoothstep(0.8, 0.86, tiled(4 * u, 7 * v, 4, 7, 43));
		return 0.86 + 0.1 * cloud + 0.05 * grain - 0.16 * eyes;
	},
	/** Bark of plates with furrows between them, such as a pine's. */
	plated(u, v) {
		const drawn = u + 0.03 * (tiled(4 * u, 5 * v, 4, 5, 51) - 0.5);
		const along = smoothstep(0.03, 0.24, ridge(tiled(9 * drawn, 3 * v, 9, 3, 52)));
		const across = smoothstep(0.02, 0.14, ridge(tiled(5 * u, 7 * v, 5, 7, 53)));
		const scales = tiled(18 * u, 26 * v, 18, 26, 54);
		return (0.5 + 0.5 * Math.min(along, across)) * (0.84 + 0.2 * scales);
	},
	/** Shiny bark with rows of marks across, such as a cherry's. */
	banded(u, v) {
		const wave = v + 0.008 * (tiled(4 * u, 3 * v, 4, 3, 61) - 0.5);
		const row = smoothstep(0.66, 0.76, tiled(7 * u, 30 * wave, 7, 30, 62));
		const sheen = tiled(3 * u, 9 * v, 3, 9, 63);
		return 0.84 + 0.16 * sheen - 0.34 * row;
	},
};

/** Returns 0 in the furrow, where noise crosses the middle of its range, and 1 farthest from it. */
function ridge(noise: number): number {
	return Math.abs(2 * noise - 1);
}

/**
 * Returns smooth noise of one octave, 0 … 1, that repeats after `across` and `along` units.
 * @param stream number of an independent noise
 */
function tiled(x: number, y: number, across: number, along: number, stream: number): number {
	const [left, low] = [Math.floor(x), Math.floor(y)];
	const corner = (dx: number, dy: number) =>
		hashFraction(wrapped(left + dx, across) + 4096 * wrapped(low + dy, along), stream);
	const [fx, fy] = [smoothstep(0, 1, x - left), smoothstep(0, 1, y - low)];
	const below = corner(0, 0) + fx * (corner(1, 0) - corner(0, 0));
	const above = corner(0, 1) + fx * (corner(1, 1) - corner(0, 1));
	return below + fy * (above - below);
}

/** Returns the remainder, 0 … `count` − 1, also of negative numbers. */
function wrapped(cell: number, count: number): number {
	return ((cell % count) + count) % count;
}
