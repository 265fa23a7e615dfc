/** The picture that all cards of a tree share: a tile for each kind of leaves, and one for each plane of coarser levels. */
import type { Colour } from "../../plant/colour";
import type { Picture } from "../../plant/material";
import { type Canvas, encodedByte } from "./raster";

/** A rectangle of pixels. */
export interface Tile {
	readonly x: number;
	readonly y: number;
	readonly width: number;
	readonly height: number;
}

/** Samples along an edge of a pixel. */
export const SAMPLES = 2;
/** Clear pixels around each tile, so that smaller copies of the atlas do not mix tiles. */
const MARGIN = 1;
/** Rounds that spread the colour of leaves into clear pixels around them. */
const BLEED = 3;
/** Steps of colours: fewer than 256 make small files; grain hides them. */
const COLOUR_STEP = 4;
/** Steps of the search for the largest scale at which all tiles find room. */
const SCALES = 40;

/**
 * Places rectangles in a strip, row by row, the highest first, at the largest scale at which they find room.
 * @param sizes width and height of each, in metres
 * @param strip the pixels that they may use
 * @returns the tile of each, and pixels per metre
 */
export function packed(
	sizes: readonly (readonly [width: number, height: number])[],
	strip: Tile,
): { tiles: Tile[]; scale: number } {
	const area = sizes.reduce((sum, [width, height]) => sum + width * height, 0);
	let scale = Math.sqrt((strip.width * strip.height) / Math.max(1e-9, area));
	for (let step = 0; step < SCALES; step++, scale *= 0.95) {
		const tiles = placedTiles(sizes, strip, scale);
		if (tiles) return { tiles, scale };
	}
	const { x, y } = strip;
	return { tiles: sizes.map(() => ({ x, y, width: 1, height: 1 })), scale };
}

/** Returns the tiles at a scale; undefined where they find no room. */
function placedTiles(
	sizes: readonly (readonly [width: number, height: number])[],
	strip: Tile,
	scale: number,
): Tile[] | undefined {
	const pixels = (length: number) => Math.max(2, Math.round(length * scale));
	const order = sizes.map((_, i) => i).sort((a, b) => sizes[b][1] - sizes[a][1] || a - b);
	const tiles: Tile[] = [];
	let [x, y, rowHeight] = [0, 0, 0];
	for (const i of order) {
		const [width, height] = [pixels(sizes[i][0]), pixels(sizes[i][1])];
		if (x > 0 && x + width + 2 * MARGIN > strip.width) [x, y, rowHeight] = [0, y + rowHeight, 0];
		rowHeight = Math.max(rowHeight, height + 2 * MARGIN);
		if (width + 2 * MARGIN > strip.width || y + rowHeight > strip.height) return undefined;
		tiles[i] = { x: strip.x + x + MARGIN, y: strip.y + y + MARGIN, width, height };
		x += width + 2 * MARGIN;
	}
	return tiles;
}

export class AtlasPicture {
	/** 4 × pixels: sRGB and coverage. */
	readonly #pixels: Uint8Array;
	readonly #sum: Colour = [0, 0, 0];
	#count = 0;

	/** @param width in pixels @param height in pixels */
	constructor(
		readonly width: number,
		readonly height: number,
	) {
		this.#pixels = new Uint8Array(4 * width * height);
	}

	/** Copies a canvas of SAMPLES times the size of the tile into it, with means of the samples. */
	copy(canvas: Canvas, { x, y, width, height }: Tile): void {
		const count = width * height;
		const [shares, colours] = [new Float32Array(count), new Float32Array(3 * count)];
		for (let sample = 0; sample < canvas.covered.length; sample++) {
			if (!canvas.covered[sample]) continue;
			const column = Math.floor((sample % canvas.width) / SAMPLES);
			const pixel = width * Math.floor(sample / canvas.width / SAMPLES) + column;
			shares[pixel]++;
			for (let k = 0; k < 3; k++) colours[3 * pixel + k] += canvas.colours[3 * sample + k];
		}
		for (let pixel = 0; pixel < count; pixel++) {
			if (shares[pixel] === 0) continue;
			this.#count++;
			for (let k = 0; k < 3; k++) {
				colours[3 * pixel + k] /= shares[pixel];
				this.#sum[k] += colours[3 * pixel + k];
			}
			shares[pixel] /= SAMPLES * SAMPLES;
		}
		const threshold = thresholdOf(shares);
		bleed(shares, colours, width);
		for (let pixel = 0; pixel < count; pixel++) {
			const to = 4 * (this.width * (y + Math.floor(pixel / width)) + x + (pixel % width));
			for (let k = 0; k < 3; k++) this.#pixels[to + k] = stepped(encodedByte(colours[3 * pixel + k]));
			this.#pixels[to + 3] = coverageByte((0.5 * Math.max(0, shares[pixel])) / threshold);
		}
	}

	/** The mean colour of leaves, linear light. */
	get colour(): Colour {
		return this.#sum.map((value) => value / Math.max(1, this.#count)) as Colour;
	}

	/** Returns the picture; clear pixels have the mean colour. */
	picture(): Picture {
		const bytes = this.colour.map((value) => stepped(encodedByte(value)));
		const pixels = this.#pixels;
		for (let i = 0; i < pixels.length; i += 4)
			if (pixels[i + 3] === 0 && pixels[i] + pixels[i + 1] + pixels[i + 2] === 0) pixels.set(bytes, i);
		return { width: this.width, height: this.height, pixels };
	}
}

/** Rounds a byte to a multiple of COLOUR_STEP. */
const stepped = (byte: number) => Math.min(255, COLOUR_STEP * Math.round(byte / COLOUR_STEP));

/** Returns coverage as a byte, in a few steps. */
const coverageByte = (share: number) => Math.min(255, 51 * Math.round(5 * Math.min(1, share)));

/**
 * Returns the coverage above which as many pixels lie as leaves cover in all, so that a test of half coverage keeps
 * their area, even of needles thinner than a pixel (Castaño 2010, "Computing alpha mipmaps").
 */
function thresholdOf(shares: Float32Array): number {
	const levels = SAMPLES * SAMPLES;
	const counts = new Array<number>(levels + 1).fill(0);
	let total = 0;
	for (const share of shares) {
		counts[Math.round(levels * share)]++;
		total += share;
	}
	let [best, least] = [1, Number.POSITIVE_INFINITY];
	for (let level = levels, above = 0; level > 0; level--) {
		above += counts[level];
		if (Math.abs(above - total) >= least) continue;
		[best, least] = [level / levels, Math.abs(above - total)];
	}
	return best;
}

/** Spreads colours into clear pixels (share 0) around covered ones, which then have the share −1: coverage stays 0. */
function bleed(shares: Float32Array, colours: Float32Array, width: number): void {
	for (let round = 0; round < BLEED; round++) {
		const before = shares.slice();
		for (let pixel = 0; pixel < shares.length; pixel++) {
			if (before[pixel] !== 0) continue;
			const column = pixel % width;
			let count = 0;
			const sum = [0, 0, 0];
			for (const other of [
				pixel - width,
				pixel + width,
				column > 0 ? pixel - 1 : -1,
				column < width - 1 ? pixel + 1 : -1,
			]) {
				if (!(other >= 0 && other < shares.length) || before[other] === 0) continue;
				count++;
				for (let k = 0; k < 3; k++) sum[k] += colours[3 * other + k];
			}
			if (count === 0) continue;
			shares[pixel] = -1;
			for (let k = 0; k < 3; k++) colours[3 * pixel + k] = sum[k] / count;
		}
	}
}
