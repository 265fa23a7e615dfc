/**
 * Vertex colours as a picture with texture coordinates, for readers without vertex colours. The colours of a plant are
 * near a plane in colour space: the picture is that plane, along its two principal axes, so that colours interpolate
 * between vertices.
 */
import { type Colour, clamp, encoded } from "../plant/colour";
import type { Material, Picture } from "../plant/material";
import type { Part, Shape } from "../plant/part";

/** Pixels along an edge; eight bits have no more visible steps. */
const EDGE = 64;
const ROUNDS = 60;
/** The least spread of colours beside the first axis, as a share of the whole spread. */
const LEAST_SPREAD = 1e-9;

export interface Palette {
	picture: Picture;
	/** 2 × vertices: u to the right, v down. */
	uvs: Float32Array;
}

/**
 * Parts with their vertex colours in a picture, unless they have a picture already; their own texture coordinates are
 * dropped. Parts with instances stay as they are.
 */
export function paletted(parts: readonly Part[]): Part[] {
	return parts.map(({ shape, children, ...part }) => ({
		...part,
		...(shape ? { shape: withPalette(shape) } : {}),
		...(children ? { children: paletted(children) } : {}),
	}));
}

/**
 * Shapes with vertex colours in a picture, one picture per material, for readers that would show one colour. Shapes
 * with variants, instances or a picture stay as they are, and are not in the result.
 */
export function palettedByMaterial(shapes: readonly Shape[]): Map<Shape, Shape> {
	const groups = new Map<Material, Shape[]>();
	for (const shape of shapes) {
		const { mesh, material, instances, variant } = shape;
		if (!mesh.colours || instances || variant !== undefined || material.textures?.colour) continue;
		const group = groups.get(material);
		if (group) group.push(shape);
		else groups.set(material, [shape]);
	}
	const result = new Map<Shape, Shape>();
	for (const [material, group] of groups) {
		const coloursOf = ({ mesh }: Shape) => mesh.colours as Float32Array;
		// One palette for the vertex colours of all shapes, in their order.
		const allColours = new Float32Array(group.reduce((sum, shape) => sum + coloursOf(shape).length, 0));
		let at = 0;
		for (const shape of group) {
			allColours.set(coloursOf(shape), at);
			at += coloursOf(shape).length;
		}
		const { picture, uvs } = paletteOf(allColours);
		const palettedMaterial = { ...material, textures: { ...material.textures, colour: picture } };
		at = 0;
		for (const shape of group) {
			const { colours: _, ...bare } = shape.mesh;
			const end = at + (2 * coloursOf(shape).length) / 3;
			result.set(shape, { ...shape, mesh: { ...bare, uvs: uvs.slice(at, end) }, material: palettedMaterial });
			at = end;
		}
	}
	return result;
}

/** Returns a shape with its vertex colours in a picture of its own. */
function withPalette(shape: Shape): Shape {
	const { mesh, material, instances } = shape;
	if (!mesh.colours || instances || material.textures?.colour) return shape;
	const { colours, ...bare } = mesh;
	const { picture, uvs } = paletteOf(colours);
	return { ...shape, mesh: { ...bare, uvs }, material: { ...material, textures: { colour: picture } } };
}

/**
 * Computes the picture of the plane that is nearest to the colours, and each vertex's place in it.
 * @param colours 3 × vertices, linear light
 */
export function paletteOf(colours: Float32Array): Palette {
	const srgb = new Float32Array(colours.length);
	for (let i = 0; i < colours.length; i += 3) srgb.set(encoded([colours[i], colours[i + 1], colours[i + 2]]), i);
	const count = Math.max(1, colours.length / 3);
	const mean = [0, 1, 2].map((k) => srgb.reduce((sum, value, i) => (i % 3 === k ? sum + value : sum), 0) / count);
	const spread = covariance(srgb, mean);
	const totalSpread = traceOf(spread);
	const first = principalAxis(spread);
	const remaining = withoutAxis(spread, first);
	// Colours on a line have no second axis: rounding errors would choose one.
	const second: Colour = traceOf(remaining) > LEAST_SPREAD * totalSpread ? principalAxis(remaining) : [0, 0, 0];
	const axes = [first, second];
	const coordinates = new Float32Array(2 * count);
	const [low, high] = [
		[0, 0],
		[0, 0],
	];
	for (let vertex = 0; vertex < colours.length / 3; vertex++) {
		for (const [j, axis] of axes.entries()) {
			const value = [0, 1, 2].reduce((sum, k) => sum + axis[k] * (srgb[3 * vertex + k] - mean[k]), 0);
			coordinates[2 * vertex + j] = value;
			low[j] = Math.min(low[j], value);
			high[j] = Math.max(high[j], value);
		}
	}
	const ranges = low.map((value, j) => high[j] - value || 1);
	const pixels = new Uint8Array(3 * EDGE * EDGE);
	for (let i = 0; i < pixels.length; i++) {
		const [x, y, k] = [Math.floor(i / 3) % EDGE, Math.floor(i / 3 / EDGE), i % 3];
		const planePoint = [x, y].map((step, j) => low[j] + (step / (EDGE - 1)) * ranges[j]);
		pixels[i] = Math.round(255 * clamp(mean[k] + planePoint[0] * first[k] + planePoint[1] * second[k]));
	}
	// From the middle of the first pixel to the middle of the last.
	const uvs = coordinates.map((value, i) => (0.5 + ((value - low[i % 2]) / ranges[i % 2]) * (EDGE - 1)) / EDGE);
	return { picture: { width: EDGE, height: EDGE, pixels }, uvs };
}

type Matrix = number[][];

/** Returns the covariance matrix of colours, not divided by their number. */
function covariance(values: Float32Array, mean: readonly number[]): Matrix {
	const sums = [0, 1, 2].map(() => [0, 0, 0]);
	for (let at = 0; at < values.length; at += 3) {
		for (const [i, row] of sums.entries()) {
			for (let j = 0; j < 3; j++) row[j] += (values[at + i] - mean[i]) * (values[at + j] - mean[j]);
		}
	}
	return sums;
}

/** Returns the trace of a matrix: the sum of its diagonal, here the whole spread of colours. */
const traceOf = (matrix: Matrix) => matrix[0][0] + matrix[1][1] + matrix[2][2];

/**
 * Returns the axis of the largest spread, of unit length: the eigenvector of the largest eigenvalue, by power
 * iteration.
 */
function principalAxis(matrix: Matrix): Colour {
	let axis: Colour = [0.6, 0.64, 0.48];
	for (let round = 0; round < ROUNDS; round++) {
		const [x, y, z] = matrix.map((row) => row[0] * axis[0] + row[1] * axis[1] + row[2] * axis[2]);
		const length = Math.hypot(x, y, z);
		if (length < 1e-20) return axis;
		axis = [x / length, y / length, z / length];
	}
	return axis;
}

/** Returns the covariance matrix without the spread along an axis (deflation). */
function withoutAxis(matrix: Matrix, axis: Colour): Matrix {
	const product = matrix.map((row) => row[0] * axis[0] + row[1] * axis[1] + row[2] * axis[2]);
	const strength = product[0] * axis[0] + product[1] * axis[1] + product[2] * axis[2];
	return matrix.map((row, i) => row.map((value, j) => value - strength * axis[i] * axis[j]));
}
