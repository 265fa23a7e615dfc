/**
 * Textures of a blade's faces: colour, normals, thickness. Each picture shows its face from its side, tip up, the
 * first row at the top: u runs right and v down without mirroring, as glTF requires of normal maps
 * (plant/material.ts).
 */
import { type Colour, encoded } from "../../../plant/colour";
import type { Picture } from "../../../plant/material";
import type { Leaf } from "../grown";
import type { LeafSpecimen } from "../specimen";
import { type BladeColour, bladeColours } from "./blade_colour";
import { type BladeFields, bladeFields } from "./blade_fields";
import { faceColour, type Side } from "./materials";
import { type VeinRaster, veinRaster } from "./vein_raster";

/** Width and height of final textures, pixels. */
export const SIDE = 1024;
/** Width and height of previews, pixels. */
export const PREVIEW_SIDE = 256;

/** Pixels per cell of the blade's fields. */
const PIXELS_PER_CELL = 6;
/** Depth of the grooves above veins relative to the ridges below, and its limit as a share of the thickness. */
const GROOVE = 0.4;
const DEEPEST = 0.5;
/** Opacity of the veins' colour. */
const INK = 0.85;
const FLAT = [128, 128, 255] as const;

/** The part of a leaf that textures depend on. */
export type FlatLeaf = Pick<Leaf, "chart" | "margin" | "square" | "energy"> & {
	segments: Pick<Leaf["segments"], "count" | "radii">;
};

/** The textures of one face. */
export interface FaceTextures {
	/** Colour, sRGB. */
	colour: Picture;
	normal: Picture;
	/** Mean colour of the blade, linear light. */
	mean: Colour;
}

/** Normal map of a flat face. */
export const FLAT_PICTURE: Picture = { width: 1, height: 1, pixels: Uint8Array.from(FLAT) };

/** Textures of one leaf, each computed on first use. */
export class FacePictures {
	readonly #leaf: FlatLeaf;
	readonly #millimetres: number;
	readonly #side: number;
	readonly #flat: boolean;
	#raster: VeinRaster | undefined;
	#fields: { seed: number; made: BladeFields } | undefined;
	readonly #normals = new Map<string, Picture>();

	/**
	 * @param millimetres length of the leaf
	 * @param side width and height, pixels
	 * @param flat omits the relief of veins, which takes less time
	 */
	constructor(leaf: FlatLeaf, millimetres: number, side: number, flat = false) {
		this.#leaf = leaf;
		this.#flat = flat;
		this.#millimetres = millimetres;
		this.#side = side;
	}

	face(specimen: Pick<LeafSpecimen, "look" | "parameters" | "seed">, side: Side): FaceTextures {
		const { picture, mean } = this.colour(specimen, side);
		return { colour: picture, normal: this.#flat ? FLAT_PICTURE : this.normal(specimen.parameters, side), mean };
	}

	/** The colour in sRGB, and the blade's mean in linear light. */
	colour({ look, seed }: Pick<LeafSpecimen, "look" | "seed">, face: Side): { picture: Picture; mean: Colour } {
		const fields = this.#fieldsOf(seed);
		const paint = painted(fields, bladeColours(look, faceColour(look, face)));
		return { picture: colourPicture(this.raster, fields, paint, face), mean: paint.mean };
	}

	/** Normal map of the veins on a flat blade: green is up. */
	normal({ relief, thickness }: LeafSpecimen["parameters"], face: Side): Picture {
		const key = JSON.stringify([relief, thickness, face]);
		const known = this.#normals.get(key) ?? normals(this.raster, relief, thickness, face);
		this.#normals.set(key, known);
		return known;
	}

	/** Thickness as a share of `thickest`. */
	thickness({ relief, thickness }: LeafSpecimen["parameters"], face: Side): Picture {
		const { side, height } = this.raster;
		const thickest = this.thickest({ relief, thickness });
		const pixels = new Uint8Array(3 * side * side);
		for (let at = 0; at < height.length; at++) {
			const column = face === "upper" ? at % side : side - 1 - (at % side);
			const to = 3 * ((side - 1 - Math.floor(at / side)) * side + column);
			pixels.fill(Math.round((255 * (thickness + relief * height[at])) / thickest), to, to + 3);
		}
		return { width: side, height: side, pixels };
	}

	/** Largest thickness of blade and vein together, millimetres. */
	thickest({ relief, thickness }: LeafSpecimen["parameters"]): number {
		return thickness + relief * this.raster.height.reduce((most, height) => Math.max(most, height), 0);
	}

	get raster(): VeinRaster {
		this.#raster ??= veinRaster(this.#leaf, this.#millimetres, this.#side, !this.#flat);
		return this.#raster;
	}

	#fieldsOf(seed: number): BladeFields {
		if (this.#fields?.seed !== seed) {
			const cells = Math.ceil(this.#side / PIXELS_PER_CELL);
			this.#fields = { seed, made: bladeFields(this.#leaf, this.#millimetres, seed, cells) };
		}
		return this.#fields.made;
	}
}

interface Painted {
	/** By cell: blade red, green, blue, vein red, green, blue, 0 … 255 in sRGB; far from the leaf the mean. */
	cells: Float32Array;
	/** Mean colour of the blade, linear light. */
	mean: Colour;
}

function painted(fields: BladeFields, colourAt: (fields: BladeFields, at: number) => BladeColour): Painted {
	const cells = new Float32Array(6 * fields.near.length);
	const mean: Colour = [0, 0, 0];
	let inside = 0;
	for (let at = 0; at < fields.near.length; at++) {
		if (!fields.near[at]) continue;
		const { blade, vein } = colourAt(fields, at);
		put(cells, at, blade, vein);
		if (fields.edge[at] <= 0) continue;
		inside++;
		for (let k = 0; k < 3; k++) mean[k] += blade[k];
	}
	for (let k = 0; k < 3; k++) mean[k] /= Math.max(1, inside);
	for (let at = 0; at < fields.near.length; at++) if (!fields.near[at]) put(cells, at, mean, mean);
	return { cells, mean };
}

function put(cells: Float32Array, at: number, blade: Colour, vein: Colour): void {
	for (let k = 0; k < 3; k++) {
		cells[6 * at + k] = shown(blade[k]);
		cells[6 * at + 3 + k] = shown(vein[k]);
	}
}

const SHADES = 4096;
const ENCODED = Float32Array.from({ length: SHADES + 1 }, (_, i) => 255 * encoded([i / SHADES, 0, 0])[0]);

/** Converts linear light to sRGB, 0 … 255. */
function shown(value: number): number {
	return ENCODED[Math.round(SHADES * Math.min(1, Math.max(0, value)))];
}

/** The colour picture: the blade's colours interpolated between cells, with veins over them. */
function colourPicture(
	{ side, ink: veins }: VeinRaster,
	fields: BladeFields,
	{ cells, mean }: Painted,
	face: Side,
): Picture {
	const pixels = filled(side, mean.map(shown) as Colour);
	const scale = fields.side / side;
	const line = new Float32Array(6 * fields.side);
	const step = face === "upper" ? 3 : -3;
	const lefts = new Uint16Array(side);
	const parts = new Float32Array(side);
	for (let column = 0; column < side; column++) {
		const across = Math.min(fields.side - 1.001, Math.max(0, (column + 0.5) * scale - 0.5));
		lefts[column] = 6 * Math.floor(across);
		parts[column] = across - Math.floor(across);
	}
	for (let row = 0; row < side; row++) {
		const place = (row + 0.5) * scale - 0.5;
		const [from, to] = extent(fields, place);
		if (from > to) continue;
		blend(cells, fields.side, place, line);
		const last = Math.min(side - 1, Math.ceil((to + 1.5) / scale));
		const first = Math.max(0, Math.floor((from - 0.5) / scale));
		let at = 3 * ((side - 1 - row) * side + (face === "upper" ? 0 : side - 1)) + step * first;
		for (let column = first; column <= last; column++, at += step) {
			const left = lefts[column];
			const part = parts[column];
			const ink = INK * veins[row * side + column];
			let red = line[left] + part * (line[left + 6] - line[left]);
			let green = line[left + 1] + part * (line[left + 7] - line[left + 1]);
			let blue = line[left + 2] + part * (line[left + 8] - line[left + 2]);
			if (ink > 0) {
				red += ink * (line[left + 3] + part * (line[left + 9] - line[left + 3]) - red);
				green += ink * (line[left + 4] + part * (line[left + 10] - line[left + 4]) - green);
				blue += ink * (line[left + 5] + part * (line[left + 11] - line[left + 5]) - blue);
			}
			pixels[at] = red + 0.5;
			pixels[at + 1] = green + 0.5;
			pixels[at + 2] = blue + 0.5;
		}
	}
	return { width: side, height: side, pixels };
}

/** The first and the last cell near the leaf in the two rows around a position; `to` < `from` where there is none. */
function extent({ side, near }: BladeFields, place: number): [from: number, to: number] {
	const low = side * Math.floor(Math.min(side - 1.001, Math.max(0, place)));
	const isNear = (column: number) => near[low + column] || near[low + side + column];
	let [from, to] = [0, side - 1];
	while (from < side && !isNear(from)) from++;
	while (to > from && !isNear(to)) to--;
	return [from, to];
}

/** Interpolates a line between two rows of cells. */
function blend(cells: Float32Array, side: number, row: number, line: Float32Array): void {
	const place = Math.min(side - 1.001, Math.max(0, row));
	const low = Math.floor(place);
	const part = place - low;
	const from = 6 * side * low;
	for (let k = 0; k < 6 * side; k++) line[k] = cells[from + k] + part * (cells[from + 6 * side + k] - cells[from + k]);
}

function normals({ side, cell, height }: VeinRaster, relief: number, thickness: number, face: Side): Picture {
	const rise = face === "lower" ? height.map((high) => relief * high) : grooves(height, relief, thickness);
	const pixels = filled(side, FLAT);
	const steep = 1 / (2 * cell);
	const sign = face === "upper" ? 1 : -1;
	for (let row = 0; row < side; row++) {
		const below = row > 0 ? -side : 0;
		const above = row < side - 1 ? side : 0;
		const start = 3 * ((side - 1 - row) * side + (face === "upper" ? 0 : side - 1));
		for (let column = 0; column < side; column++) {
			const at = row * side + column;
			const right = rise[column < side - 1 ? at + 1 : at] - rise[column > 0 ? at - 1 : at];
			const up = rise[at + above] - rise[at + below];
			if (right === 0 && up === 0) continue;
			const nx = -sign * steep * right;
			const ny = -steep * up;
			const half = 127.5 / Math.sqrt(nx * nx + ny * ny + 1);
			const to = start + 3 * sign * column;
			pixels[to] = 128 + nx * half;
			pixels[to + 1] = 128 + ny * half;
			pixels[to + 2] = 128 + half;
		}
	}
	return { width: side, height: side, pixels };
}

/** Height of the upper face: it sinks in over veins, at most to `DEEPEST` of the thickness. */
function grooves(height: Float32Array, relief: number, thickness: number): Float32Array {
	const deepest = DEEPEST * thickness;
	return height.map((high) => (high === 0 ? 0 : -deepest * (1 - Math.exp((-GROOVE * relief * high) / deepest))));
}

/** Pixels of one colour, 0 … 255. */
function filled(side: number, colour: readonly [number, number, number]): Uint8Array {
	const pixels = new Uint8Array(3 * side * side);
	for (let k = 0; k < 3; k++) pixels[k] = Math.round(colour[k]);
	for (let done = 3; done < pixels.length; done *= 2) pixels.copyWithin(done, 0, Math.min(done, pixels.length - done));
	return pixels;
}
