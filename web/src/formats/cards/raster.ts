/**
 * Draws triangles without a graphics card: orthographic pictures of clusters of leaves and of whole trees, with colour,
 * coverage, normal and depth. Needs no WebGL, so that files are the same in pages, workers and Node.
 */
import type { Colour } from "../../plant/colour";
import type { Picture } from "../../plant/material";
import type { Vector } from "../../plant/part";

/** Triangles to draw. */
export interface Drawn {
	/** 3 × vertices, in the plant's frame. */
	readonly positions: ArrayLike<number>;
	readonly normals: ArrayLike<number>;
	/** 2 × vertices; may be empty. */
	readonly uvs: ArrayLike<number>;
	readonly indices: ArrayLike<number>;
	/** 3 × vertices, linear light; multiplies the picture. */
	readonly colours?: ArrayLike<number> | undefined;
	/** Linear light; multiplies the picture. */
	readonly colour: Colour;
	readonly picture?: LinearPicture | undefined;
	/** Whether normals turn towards the viewer. */
	readonly doubleSided: boolean;
}

/** A picture in linear light, for sampling. */
export interface LinearPicture {
	readonly width: number;
	readonly height: number;
	/** 4 × pixels: linear light, and coverage 0 … 1. */
	readonly pixels: Float32Array;
}

const DECODED = Float32Array.from({ length: 256 }, (_, byte) => {
	const channel = byte / 255;
	return channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4;
});

/** Converts a picture of 3 or 4 channels to linear light. */
export function linearPicture({ width, height, pixels }: Picture): LinearPicture {
	const channels = pixels.length / (width * height);
	const linear = new Float32Array(4 * width * height);
	for (let i = 0; i < width * height; i++) {
		for (let k = 0; k < 3; k++) linear[4 * i + k] = DECODED[pixels[channels * i + k]];
		linear[4 * i + 3] = channels === 4 ? pixels[channels * i + 3] / 255 : 1;
	}
	return { width, height, pixels: linear };
}

const STEPS = 4096;
const ENCODED = Uint8Array.from({ length: STEPS + 1 }, (_, i) => {
	const value = i / STEPS;
	return Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
});

/** Converts linear light 0 … 1 to a byte of sRGB. */
export const encodedByte = (light: number): number => ENCODED[Math.round(STEPS * Math.min(1, Math.max(0, light)))];

/** A view from far away: a rectangle in the plant's frame that the canvas shows. */
export interface OrthographicView {
	/** The middle of the rectangle. */
	readonly middle: Vector;
	/** Unit vectors: to the right, up, and towards the viewer. */
	readonly right: Vector;
	readonly up: Vector;
	readonly towards: Vector;
	/** Half the width and half the height, metres. */
	readonly halfWidth: number;
	readonly halfHeight: number;
}

/** Pixels without coverage have this depth. */
const FAR = -1e30;

export class Canvas {
	/** 3 × pixels, linear light. */
	readonly colours: Float32Array;
	/** 3 × pixels, in the frame of the view: right, up, towards the viewer. */
	readonly normals: Float32Array;
	/** Towards the viewer from the middle of the view, metres. */
	readonly depths: Float32Array;
	/** 1 where something is drawn. */
	readonly covered: Uint8Array;

	constructor(
		readonly width: number,
		readonly height: number,
	) {
		this.colours = new Float32Array(3 * width * height);
		this.normals = new Float32Array(3 * width * height);
		this.depths = new Float32Array(width * height).fill(FAR);
		this.covered = new Uint8Array(width * height);
	}

	/** Copies another canvas into this one. */
	paste(other: Canvas, x: number, y: number): void {
		for (let row = 0; row < other.height; row++) {
			const [from, to] = [other.width * row, this.width * (y + row) + x];
			const end = from + other.width;
			this.colours.set(other.colours.subarray(3 * from, 3 * end), 3 * to);
			this.normals.set(other.normals.subarray(3 * from, 3 * end), 3 * to);
			this.depths.set(other.depths.subarray(from, end), to);
			this.covered.set(other.covered.subarray(from, end), to);
		}
	}

	/** Returns the columns, rows and depths of points in a view. */
	#projected(
		positions: Drawn["positions"],
		{ middle, right, up, towards, halfWidth, halfHeight }: OrthographicView,
	): [xs: Float32Array, ys: Float32Array, zs: Float32Array] {
		const count = positions.length / 3;
		const [xs, ys, zs] = [new Float32Array(count), new Float32Array(count), new Float32Array(count)];
		const [sx, sy] = [this.width / (2 * halfWidth), this.height / (2 * halfHeight)];
		for (let i = 0; i < count; i++) {
			const x = positions[3 * i] - middle[0];
			const y = positions[3 * i + 1] - middle[1];
			const z = positions[3 * i + 2] - middle[2];
			xs[i] = (x * right[0] + y * right[1] + z * right[2] + halfWidth) * sx - 0.5;
			ys[i] = (halfHeight - (x * up[0] + y * up[1] + z * up[2])) * sy - 0.5;
			zs[i] = x * towards[0] + y * towards[1] + z * towards[2];
		}
		return [xs, ys, zs];
	}

	/** Draws triangles; nearer ones hide others, and pixels whose picture has less than half coverage stay clear. */
	draw(
		{ positions, normals, uvs, indices, colours, colour, picture, doubleSided }: Drawn,
		view: OrthographicView,
	): void {
		const { width, height } = this;
		const { right, up, towards } = view;
		const [xs, ys, zs] = this.#projected(positions, view);
		const pictured = picture && uvs.length > 0 ? picture : undefined;
		for (let at = 0; at < indices.length; at += 3) {
			const [a, b, c] = [indices[at], indices[at + 1], indices[at + 2]];
			const [ax, ay, bx, by, cx, cy] = [xs[a], ys[a], xs[b], ys[b], xs[c], ys[c]];
			const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
			if (area === 0) continue;
			const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx)));
			const last = Math.min(width - 1, Math.floor(Math.max(ax, bx, cx)));
			const top = Math.max(0, Math.ceil(Math.min(ay, by, cy)));
			const bottom = Math.min(height - 1, Math.floor(Math.max(ay, by, cy)));
			// Steps of the weights of b and c along a row and a column.
			const [bRow, cRow] = [(cy - ay) / area, -(by - ay) / area];
			const [bColumn, cColumn] = [-(cx - ax) / area, (bx - ax) / area];
			for (let y = top; y <= bottom; y++) {
				let wb = (left - ax) * bRow + (y - ay) * bColumn;
				let wc = (left - ax) * cRow + (y - ay) * cColumn;
				for (let x = left; x <= last; x++, wb += bRow, wc += cRow) {
					const wa = 1 - wb - wc;
					if (wa < 0 || wb < 0 || wc < 0) continue;
					const pixel = width * y + x;
					const depth = wa * zs[a] + wb * zs[b] + wc * zs[c];
					if (depth <= this.depths[pixel]) continue;
					let [red, green, blue] = colour;
					if (pictured) {
						const u = wa * uvs[2 * a] + wb * uvs[2 * b] + wc * uvs[2 * c];
						const v = wa * uvs[2 * a + 1] + wb * uvs[2 * b + 1] + wc * uvs[2 * c + 1];
						const column = Math.min(pictured.width - 1, Math.floor((u - Math.floor(u)) * pictured.width));
						const row = Math.min(pictured.height - 1, Math.floor((v - Math.floor(v)) * pictured.height));
						const texel = 4 * (pictured.width * row + column);
						if (pictured.pixels[texel + 3] < 0.5) continue;
						red *= pictured.pixels[texel];
						green *= pictured.pixels[texel + 1];
						blue *= pictured.pixels[texel + 2];
					}
					if (colours) {
						red *= wa * colours[3 * a] + wb * colours[3 * b] + wc * colours[3 * c];
						green *= wa * colours[3 * a + 1] + wb * colours[3 * b + 1] + wc * colours[3 * c + 1];
						blue *= wa * colours[3 * a + 2] + wb * colours[3 * b + 2] + wc * colours[3 * c + 2];
					}
					const nx = wa * normals[3 * a] + wb * normals[3 * b] + wc * normals[3 * c];
					const ny = wa * normals[3 * a + 1] + wb * normals[3 * b + 1] + wc * normals[3 * c + 1];
					const nz = wa * normals[3 * a + 2] + wb * normals[3 * b + 2] + wc * normals[3 * c + 2];
					const facing = nx * towards[0] + ny * towards[1] + nz * towards[2];
					const side = doubleSided && facing < 0 ? -1 : 1;
					this.depths[pixel] = depth;
					this.covered[pixel] = 1;
					this.colours[3 * pixel] = red;
					this.colours[3 * pixel + 1] = green;
					this.colours[3 * pixel + 2] = blue;
					this.normals[3 * pixel] = side * (nx * right[0] + ny * right[1] + nz * right[2]);
					this.normals[3 * pixel + 1] = side * (nx * up[0] + ny * up[1] + nz * up[2]);
					this.normals[3 * pixel + 2] = side * facing;
				}
			}
		}
	}
}
