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

	/** Returns the colour and the normal map of a face. */
	face(specimen: Pick<LeafSpecimen, "look" | "parameters" | "seed">, side: Side): FaceTextures {
		const { picture, mean } = this.colour(specimen, side);
		return { colour: picture, normal: this.#flat ? FLAT_PICTURE : this.normal(specimen.parameters, side), mean };
	}

	/** Paints a face's colour in sRGB, and returns the blade's mean colour in linear light. */
	colour({ look, seed }: Pick<LeafSpecimen, "look" | "seed">, face: Side): { picture: Picture; mean: Colour } {
		const fields = this.#fieldsOf(seed);
		const paint = cellColours(fields, bladeColours(look, faceColour(look, face)));
		return { picture: colourPicture(this.raster, fields, paint, face), mean: paint.mean };
	}

	/** Returns the normal map of the veins on a flat blade (green is up); reuses the last one of the same relief. */
	normal({ relief, thickness }: LeafSpecimen["parameters"], face: Side): Picture {
		const key = JSON.stringify([relief, thickness, face]);
		const known = this.#normals.get(key) ?? normalPicture(this.raster, relief, thickness, face);
		this.#normals.set(key, known);
		return known;
	}

	/** Draws the thickness of the blade as a share of `thickest`, 0 … 255. */
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

	/** Returns the largest thickness of blade and vein together, millimetres. */
	thickest({ relief, thickness }: LeafSpecimen["parameters"]): number {
		return thickness + relief * this.raster.height.reduce((most, height) => Math.max(most, height), 0);
	}

	/** The veins in pixels, drawn at the first use. */
	get raster(): VeinRaster {
		this.#raster ??= veinRaster(this.#leaf, this.#millimetres, this.#side, !this.#flat);
		return this.#raster;
	}

	/** Returns the inputs of the blade's colour; computes them again where the seed of their noise has changed. */
	#fieldsOf(seed: number): BladeFields {
		if (this.#fields?.seed !== seed) {
			const cells = Math.ceil(this.#side / PIXELS_PER_CELL);
			this.#fields = { seed, made: bladeFields(this.#leaf, this.#millimetres, seed, cells) };
		}
		return this.#fields.made;
	}
}

interface CellColours {
	/** By cell: blade red, green, blue, vein red, green, blue, 0 … 255 in sRGB; far from the leaf the mean. */
	cells: Float32Array;
	/** Mean colour of the blade, linear light. */
	mean: Colour;
}

/**
 * Computes the colours of all cells: six values each, of the blade and of the vein. Cells far from the leaf have its
 * mean colour, so that filtered textures have no dark edge.
 */
function cellColours(fields: BladeFields, colourAt: (fields: BladeFields, at: number) => BladeColour): CellColours {
	const cells = new Float32Array(6 * fields.near.length);
	const mean: Colour = [0, 0, 0];
	let inside = 0;
	for (let at = 0; at < fields.near.length; at++) {
		if (!fields.near[at]) continue;
		const { blade, vein } = colourAt(fields, at);
		setCell(cells, at, blade, vein);
		if (fields.edge[at] <= 0) continue;
		inside++;
		for (let k = 0; k < 3; k++) mean[k] += blade[k];
	}
	for (let k = 0; k < 3; k++) mean[k] /= Math.max(1, inside);
	for (let at = 0; at < fields.near.length; at++) if (!fields.near[at]) setCell(cells, at, mean, mean);
	return { cells, mean };
}

/** Writes the six numbers of cell `at`: red, green and blue of the blade, then of the vein, converted to sRGB. */
function setCell(cells: Float32Array, at: number, blade: Colour, vein: Colour): void {
	for (let k = 0; k < 3; k++) {
		cells[6 * at + k] = toSrgb(blade[k]);
		cells[6 * at + 3 + k] = toSrgb(vein[k]);
	}
}

const LEVELS = 4096;
/** Values of sRGB, 0 … 255, of LEVELS + 1 steps of linear light. */
const ENCODED = Float32Array.from({ length: LEVELS + 1 }, (_, i) => 255 * encoded([i / LEVELS, 0, 0])[0]);

/** Converts linear light to sRGB, 0 … 255. */
function toSrgb(value: number): number {
	return ENCODED[Math.round(LEVELS * Math.min(1, Math.max(0, value)))];
}

/**
 * Draws the colour picture: the blade's colours interpolated between cells, with the veins' colours over them as dense
 * as the raster covers a pixel. A cell has six numbers: red, green, blue of the blade and of a vein.
 */
function colourPicture(
	{ side, ink: veins }: VeinRaster,
	fields: BladeFields,
	{ cells, mean }: CellColours,
	face: Side,
): Picture {
	const pixels = uniformPixels(side, mean.map(toSrgb) as Colour);
	const scale = fields.side / side;
	const rowColours = new Float32Array(6 * fields.side);
	const pixelStep = face === "upper" ? 3 : -3;
	const leftCells = new Uint16Array(side);
	const fractions = new Float32Array(side);
	for (let column = 0; column < side; column++) {
		// For each column of the picture: the cell to the left of it, as an index into `line`, and the share of the next
		// one.
		const position = Math.min(fields.side - 1.001, Math.max(0, (column + 0.5) * scale - 0.5));
		leftCells[column] = 6 * Math.floor(position);
		fractions[column] = position - Math.floor(position);
	}
	for (let row = 0; row < side; row++) {
		const rowPosition = (row + 0.5) * scale - 0.5;
		const [from, to] = columnsNear(fields, rowPosition);
		if (from > to) continue;
		// `line` has the colours of the two rows of cells around this row, interpolated.
		interpolateRow(cells, fields.side, rowPosition, rowColours);
		const last = Math.min(side - 1, Math.ceil((to + 1.5) / scale));
		const first = Math.max(0, Math.floor((from - 0.5) / scale));
		// Rows run downwards in the picture, and columns backwards on the lower face, which is seen from the other side.
		let pixel = 3 * ((side - 1 - row) * side + (face === "upper" ? 0 : side - 1)) + pixelStep * first;
		for (let column = first; column <= last; column++, pixel += pixelStep) {
			const cell = leftCells[column];
			const fraction = fractions[column];
			const ink = INK * veins[row * side + column];
			let red = rowColours[cell] + fraction * (rowColours[cell + 6] - rowColours[cell]);
			let green = rowColours[cell + 1] + fraction * (rowColours[cell + 7] - rowColours[cell + 1]);
			let blue = rowColours[cell + 2] + fraction * (rowColours[cell + 8] - rowColours[cell + 2]);
			if (ink > 0) {
				red += ink * (rowColours[cell + 3] + fraction * (rowColours[cell + 9] - rowColours[cell + 3]) - red);
				green += ink * (rowColours[cell + 4] + fraction * (rowColours[cell + 10] - rowColours[cell + 4]) - green);
				blue += ink * (rowColours[cell + 5] + fraction * (rowColours[cell + 11] - rowColours[cell + 5]) - blue);
			}
			pixels[pixel] = red + 0.5;
			pixels[pixel + 1] = green + 0.5;
			pixels[pixel + 2] = blue + 0.5;
		}
	}
	return { width: side, height: side, pixels };
}

/**
 * Returns the first and the last column near the leaf in the two rows of cells around a row coordinate; `to` < `from`
 * where there is none.
 */
function columnsNear({ side, near }: BladeFields, row: number): [from: number, to: number] {
	const first = side * Math.floor(Math.min(side - 1.001, Math.max(0, row)));
	const isNear = (column: number) => near[first + column] || near[first + side + column];
	let [from, to] = [0, side - 1];
	while (from < side && !isNear(from)) from++;
	while (to > from && !isNear(to)) to--;
	return [from, to];
}

/** Interpolates between the two rows of cells around a row coordinate, and writes the result to `rowColours`. */
function interpolateRow(cells: Float32Array, side: number, row: number, rowColours: Float32Array): void {
	const position = Math.min(side - 1.001, Math.max(0, row));
	const lowerRow = Math.floor(position);
	const fraction = position - lowerRow;
	const from = 6 * side * lowerRow;
	for (let k = 0; k < 6 * side; k++)
		rowColours[k] = cells[from + k] + fraction * (cells[from + 6 * side + k] - cells[from + k]);
}

/** Draws the normal map of a face from the veins' relief: ridges on the lower face, shallower grooves on the upper. */
function normalPicture({ side, cell, height }: VeinRaster, relief: number, thickness: number, face: Side): Picture {
	const heights = face === "lower" ? height.map((high) => relief * high) : grooves(height, relief, thickness);
	const pixels = uniformPixels(side, FLAT);
	const slopeFactor = 1 / (2 * cell);
	const sign = face === "upper" ? 1 : -1;
	for (let row = 0; row < side; row++) {
		const below = row > 0 ? -side : 0;
		const above = row < side - 1 ? side : 0;
		const rowStart = 3 * ((side - 1 - row) * side + (face === "upper" ? 0 : side - 1));
		for (let column = 0; column < side; column++) {
			const at = row * side + column;
			const right = heights[column < side - 1 ? at + 1 : at] - heights[column > 0 ? at - 1 : at];
			const up = heights[at + above] - heights[at + below];
			if (right === 0 && up === 0) continue;
			const nx = -sign * slopeFactor * right;
			const ny = -slopeFactor * up;
			const scale = 127.5 / Math.sqrt(nx * nx + ny * ny + 1);
			const pixel = rowStart + 3 * sign * column;
			pixels[pixel] = 128 + nx * scale;
			pixels[pixel + 1] = 128 + ny * scale;
			pixels[pixel + 2] = 128 + scale;
		}
	}
	return { width: side, height: side, pixels };
}

/**
 * Returns the heights of the upper face, millimetres: it sinks in over veins, at most to `DEEPEST` of the thickness.
 * @param height heights of the ridges on the lower face
 */
function grooves(height: Float32Array, relief: number, thickness: number): Float32Array {
	const deepest = DEEPEST * thickness;
	return height.map((high) => (high === 0 ? 0 : -deepest * (1 - Math.exp((-GROOVE * relief * high) / deepest))));
}

/** Returns side × side pixels of one colour, 0 … 255. */
function uniformPixels(side: number, colour: readonly [number, number, number]): Uint8Array {
	const pixels = new Uint8Array(3 * side * side);
	for (let k = 0; k < 3; k++) pixels[k] = Math.round(colour[k]);
	for (let written = 3; written < pixels.length; written *= 2)
		pixels.copyWithin(written, 0, Math.min(written, pixels.length - written));
	return pixels;
}
