/**
 * Pictures of bark: colour, normals, and occlusion with roughness, painted once for each kind. They repeat at their
 * edges, and around a stem at any quarter of their width (bark_noise.ts). They hold shares of the bark's own colour,
 * which is in the vertices.
 */
import { type Colour, clamp, encoded } from "../colour";
import type { Picture, Textures } from "../material";
import { BARK_PAINTERS, type BarkKind, type BarkPoint, HEIGHT, TILE, WIDTH } from "./bark_kinds";
import { wrapped } from "./bark_noise";

export type { BarkKind };

/** The pictures of a kind of bark. */
export interface BarkPictures {
	readonly textures: Required<Pick<Textures, "colour" | "normal" | "surface">> & { readonly repeats: true };
	/** The mean of the colour picture, in linear light: vertices have the bark's colour divided by it. */
	readonly mean: Colour;
	/** The mean of the roughness. */
	readonly roughness: number;
}

/** The light in the deepest furrows, as a share of that on an even surface, and the depth of those, in metres. */
const LEAST_LIGHT = 0.35;
const DEEP = 0.008;
/** Distance over which heights are compared for occlusion, in pixels. */
const REACH = 8;

const painted = new Map<BarkKind, BarkPictures>();

/** Returns the pictures of a kind of bark, painted on first use. */
export function barkPictures(kind: BarkKind): BarkPictures {
	const known = painted.get(kind) ?? paint(kind);
	painted.set(kind, known);
	return known;
}

/** Paints the pictures of a kind. */
function paint(kind: BarkKind): BarkPictures {
	const painter = BARK_PAINTERS[kind]();
	const count = WIDTH * HEIGHT;
	const heights = new Float32Array(count);
	const roughness = new Float32Array(count);
	const pixels = new Uint8Array(3 * count);
	const sum = [0, 0, 0];
	let rough = 0;
	const point: BarkPoint = { height: 0, red: 1, green: 1, blue: 1, roughness: 1 };
	for (let row = 0, pixel = 0; row < HEIGHT; row++)
		for (let column = 0; column < WIDTH; column++, pixel++) {
			painter(point, (column + 0.5) / WIDTH, (row + 0.5) / HEIGHT, pixel);
			heights[pixel] = point.height;
			roughness[pixel] = point.roughness;
			rough += point.roughness;
			const { red, green, blue } = point;
			sum[0] += clamp(red);
			sum[1] += clamp(green);
			sum[2] += clamp(blue);
			pixels[3 * pixel] = sRgb(red);
			pixels[3 * pixel + 1] = sRgb(green);
			pixels[3 * pixel + 2] = sRgb(blue);
		}
	return {
		textures: {
			colour: { width: WIDTH, height: HEIGHT, pixels },
			normal: normals(heights),
			surface: surface(heights, roughness),
			repeats: true,
		},
		mean: sum.map((each) => each / count) as Colour,
		roughness: rough / count,
	};
}

/** sRGB of linear light in steps of 1/1023. */
const ENCODED = Uint8Array.from({ length: 1024 }, (_, i) => {
	const light = i / 1023;
	return Math.round(255 * encoded([light, light, light])[0]);
});

/** Returns linear light, 0 … 1, as sRGB, 0 … 255. */
function sRgb(light: number): number {
	return ENCODED[Math.round(1023 * clamp(light))];
}

/** Returns the normals of a surface (plant/material.ts) of heights in metres, by central differences. */
function normals(heights: Float32Array): Picture {
	const acrossScale = (0.5 * WIDTH) / TILE[0];
	const alongScale = (0.5 * HEIGHT) / TILE[1];
	const pixels = new Uint8Array(3 * heights.length);
	for (let row = 0, pixel = 0; row < HEIGHT; row++) {
		const above = WIDTH * (row === 0 ? HEIGHT - 1 : row - 1);
		const below = WIDTH * (row === HEIGHT - 1 ? 0 : row + 1);
		const line = WIDTH * row;
		for (let column = 0; column < WIDTH; column++, pixel++) {
			const left = heights[line + (column === 0 ? WIDTH - 1 : column - 1)];
			const right = heights[line + (column === WIDTH - 1 ? 0 : column + 1)];
			const x = acrossScale * (left - right);
			const y = alongScale * (heights[below + column] - heights[above + column]);
			const scale = 127.5 / Math.sqrt(x * x + y * y + 1);
			pixels[3 * pixel] = Math.round(127.5 + scale * x);
			pixels[3 * pixel + 1] = Math.round(127.5 + scale * y);
			pixels[3 * pixel + 2] = Math.round(127.5 + scale);
		}
	}
	return { width: WIDTH, height: HEIGHT, pixels };
}

/** Returns occlusion and roughness as one picture of half the size: points are dark that lie below their surroundings. */
function surface(heights: Float32Array, roughness: Float32Array): Picture {
	const around = blurred(blurred(heights, 1), WIDTH);
	const [width, height] = [WIDTH / 2, HEIGHT / 2];
	const pixels = new Uint8Array(3 * width * height);
	for (let row = 0, to = 0; row < height; row++)
		for (let column = 0; column < width; column++, to += 3) {
			let [light, rough] = [0, 0];
			for (const at of [0, 1, WIDTH, WIDTH + 1]) {
				const from = 2 * row * WIDTH + 2 * column + at;
				light += 1 - clamp((around[from] - heights[from]) / DEEP, 0, 1 - LEAST_LIGHT);
				rough += roughness[from];
			}
			pixels[to] = Math.round((255 * light) / 4);
			pixels[to + 1] = Math.round((255 * rough) / 4);
		}
	return { width, height, pixels };
}

/**
 * Returns the means of neighbours in a line, which closes.
 * @param stride from one neighbour to the next: 1 for rows, WIDTH for columns
 */
function blurred(values: Float32Array, stride: number): Float32Array {
	const means = new Float32Array(values.length);
	const length = stride === 1 ? WIDTH : HEIGHT;
	const lines = values.length / length;
	for (let line = 0; line < lines; line++) {
		const start = stride === 1 ? line * WIDTH : line;
		const at = (i: number) => values[start + stride * wrapped(i, length)];
		let sum = 0;
		for (let i = -REACH; i <= REACH; i++) sum += at(i);
		for (let i = 0; i < length; i++) {
			means[start + stride * i] = sum / (2 * REACH + 1);
			sum += at(i + REACH + 1) - at(i - REACH);
		}
	}
	return means;
}
