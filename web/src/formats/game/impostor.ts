/**
 * An impostor: pictures of a tree from all sides and from above, in one picture whose frames lie on the upper half of an
 * octahedron (Brucks 2018, "Octahedral impostors"). A shader draws a square that faces the camera with the frames
 * nearest to its direction.
 */
import type { Picture } from "../../plant/material";
import type { PartMesh, Vector } from "../../plant/part";
import { Canvas, type Drawn, encodedByte, type OrthographicView } from "../cards/raster";
import { add, cross, dot, scaled, unit } from "../cards/vectors";
import { png } from "../png";

/** Frames along an edge of the picture. */
export const FRAMES = 8;
/** The most bytes of both pictures. */
export const IMPOSTOR_BYTES = 64_000;
/** Pixels along an edge of a frame that are tried, from large to small; each divides DRAWN. */
const EDGES = [36, 24, 18, 12];
const DRAWN = 72;
/** Crossed pictures in files, for programs without such a shader. */
const CROSSED = 4;
/** Steps of bytes, so that pictures stay small: of colours, coverage, normals and depth. */
const STEPS = { colour: 12, coverage: 51, normal: 32, depth: 16 } as const;

export interface Impostor {
	/** 4 × pixels: colour (sRGB) and coverage. */
	readonly colour: Picture;
	/** 3 × pixels: x and y of the normal in the frame of the view (128: 0), and depth (0 far, 255 near). */
	readonly surface: Picture;
	readonly colourPng: Uint8Array<ArrayBuffer>;
	readonly surfacePng: Uint8Array<ArrayBuffer>;
	/** Pixels along an edge of a frame. */
	readonly frame: number;
	/** The ball that each frame shows, metres. */
	readonly middle: Vector;
	readonly radius: number;
}

/** Returns the direction from which a frame is seen: column and row 0 … FRAMES − 1, from the upper left corner. */
export function frameDirection(column: number, row: number): Vector {
	const [u, v] = [(2 * column) / (FRAMES - 1) - 1, (2 * row) / (FRAMES - 1) - 1];
	const [x, z] = [0.5 * (u + v), 0.5 * (u - v)];
	return unit([x, Math.max(0, 1 - Math.abs(x) - Math.abs(z)), z]);
}

/** Returns the view of the ball from a direction. */
export function frameView(towards: Vector, middle: Vector, radius: number): OrthographicView {
	const right = Math.abs(towards[1]) > 0.9999 ? ([1, 0, 0] as Vector) : unit(cross([0, 1, 0], towards));
	return { middle, right, up: cross(towards, right), towards, halfWidth: radius, halfHeight: radius };
}

/** Draws the frames of a tree, as large as the limit of bytes allows. */
export function drawImpostor(
	drawn: readonly Drawn[],
	{ middle, radius }: Pick<Impostor, "middle" | "radius">,
): Impostor {
	const edge = FRAMES * DRAWN;
	const whole = new Canvas(edge, edge);
	for (let row = 0; row < FRAMES; row++)
		for (let column = 0; column < FRAMES; column++) {
			const canvas = new Canvas(DRAWN, DRAWN);
			const view = frameView(frameDirection(column, row), middle, radius);
			for (const each of drawn) canvas.draw(each, view);
			whole.paste(canvas, DRAWN * column, DRAWN * row);
		}
	for (const frame of EDGES) {
		const made = shrunkTo(whole, frame, radius);
		const [colourPng, surfacePng] = [png(made.colour), png(made.surface)];
		if (colourPng.length + surfacePng.length <= IMPOSTOR_BYTES || frame === EDGES[EDGES.length - 1])
			return { ...made, colourPng, surfacePng, frame, middle, radius };
	}
	throw new Error("no frame");
}

/** Returns the pictures of a canvas with `frame` pixels per frame: means of the samples of each pixel. */
function shrunkTo(whole: Canvas, frame: number, radius: number): Pick<Impostor, "colour" | "surface"> {
	const samples = DRAWN / frame;
	const edge = FRAMES * frame;
	const colour = new Uint8Array(4 * edge * edge);
	const surface = new Uint8Array(3 * edge * edge);
	const mean = [0, 0, 0];
	let covered = 0;
	for (let pixel = 0; pixel < edge * edge; pixel++) {
		const [column, row] = [pixel % edge, Math.floor(pixel / edge)];
		let [count, x, y, depth] = [0, 0, 0, 0];
		const sum = [0, 0, 0];
		for (let j = 0; j < samples; j++)
			for (let i = 0; i < samples; i++) {
				const at = whole.width * (samples * row + j) + samples * column + i;
				if (!whole.covered[at]) continue;
				count++;
				for (let k = 0; k < 3; k++) sum[k] += whole.colours[3 * at + k];
				x += whole.normals[3 * at];
				y += whole.normals[3 * at + 1];
				depth += whole.depths[at];
			}
		surface.set([128, 128, 0], 3 * pixel);
		if (count === 0) continue;
		covered++;
		for (let k = 0; k < 3; k++) {
			mean[k] += sum[k] / count;
			colour[4 * pixel + k] = stepped(encodedByte(sum[k] / count), STEPS.colour);
		}
		colour[4 * pixel + 3] = stepped((255 * count) / (samples * samples), STEPS.coverage);
		surface[3 * pixel] = stepped(127.5 + (127.5 * x) / count, STEPS.normal);
		surface[3 * pixel + 1] = stepped(127.5 + (127.5 * y) / count, STEPS.normal);
		surface[3 * pixel + 2] = stepped(127.5 + (127.5 * depth) / count / radius, STEPS.depth);
	}
	const clear = mean.map((value) => stepped(encodedByte(value / Math.max(1, covered)), STEPS.colour));
	for (let i = 0; i < colour.length; i += 4) if (colour[i + 3] === 0) colour.set(clear, i);
	return {
		colour: { width: edge, height: edge, pixels: colour },
		surface: { width: edge, height: edge, pixels: surface },
	};
}

/** Rounds a byte to a multiple of a step. */
const stepped = (byte: number, step: number) => Math.max(0, Math.min(255, step * Math.round(byte / step)));

/** Returns crossed upright pictures from the horizon, for programs that do not know impostors. */
export function crossedPictures({ middle, radius }: Pick<Impostor, "middle" | "radius">): PartMesh {
	const frames = Array.from({ length: CROSSED }, (_, k) => nearestFrame((Math.PI * (k + 0.5)) / CROSSED));
	const [positions, normals, uvs, indices]: number[][] = [[], [], [], []];
	for (const [i, { column, row, view }] of frames.entries()) {
		for (const [x, y] of [
			[-1, -1],
			[1, -1],
			[-1, 1],
			[1, 1],
		]) {
			positions.push(...add(middle, add(scaled(view.right, x * radius), scaled(view.up, y * radius))));
			// Light falls on all sides alike.
			normals.push(0, 1, 0);
			uvs.push((column + 0.5 + 0.5 * x) / FRAMES, (row + 0.5 - 0.5 * y) / FRAMES);
		}
		indices.push(...[0, 1, 2, 2, 1, 3].map((corner) => 4 * i + corner));
	}
	return {
		positions: Float32Array.from(positions),
		normals: Float32Array.from(normals),
		uvs: Float32Array.from(uvs),
		indices: Uint32Array.from(indices),
	};

	/** Returns the frame on the horizon that is nearest to an azimuth. */
	function nearestFrame(azimuth: number): { column: number; row: number; view: OrthographicView } {
		const wanted: Vector = [Math.sin(azimuth), 0, Math.cos(azimuth)];
		let best = { column: 0, row: 0 };
		let most = -1;
		for (let row = 0; row < FRAMES; row++)
			for (let column = 0; column < FRAMES; column++) {
				const alike = dot(frameDirection(column, row), wanted);
				if (alike > most + 1e-9) [best, most] = [{ column, row }, alike];
			}
		return { ...best, view: frameView(frameDirection(best.column, best.row), middle, radius) };
	}
}
