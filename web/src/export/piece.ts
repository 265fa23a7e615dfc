/** What light forms of a file are made from: all that is drawn of a plant, each where it stands. */
import type { Material } from "../plant/material";
import { everyPart, type Part, type PartMesh, type Shape, TRANSFORM } from "../plant/part";
import { placed } from "./together";
import { writtenColours } from "./vertex_colours";

/** Triangles of one material in the plant's frame; the shade in which they stand is in their colours. */
export interface Piece {
	material: Material;
	mesh: PartMesh;
}

/**
 * Every mesh, and every instance of one by itself.
 * @param held whether instances are to say where they are held (`feet`)
 */
export function* piecesOf(parts: Iterable<Part>, held = false): Generator<Piece> {
	for (const { shape } of everyPart(parts)) {
		if (shape?.instances) yield* instancesOf(shape, shape.instances.transforms, shape.instances.sky, held);
		else if (shape) yield piece(shape);
	}
}

function* instancesOf(
	{ mesh, material }: Shape,
	transforms: Float32Array,
	sky: Uint8Array | undefined,
	held: boolean,
): Generator<Piece> {
	for (let i = 0; i < transforms.length / TRANSFORM; i++) {
		const { positions, normals } = placed(mesh, transforms.subarray(TRANSFORM * i, TRANSFORM * (i + 1)));
		const own: PartMesh = { ...mesh, positions: Float32Array.from(positions), normals: Float32Array.from(normals) };
		if (held) own.feet = own.positions.map((_, at) => transforms[TRANSFORM * i + (at % 3)]);
		if (sky) own.sky = new Uint8Array(positions.length / 3).fill(sky[i]);
		yield piece({ mesh: own, material });
	}
}

function piece({ mesh, material }: Pick<Shape, "mesh" | "material">): Piece {
	const { sky: _, colours: __, ...bare } = mesh;
	const colours = writtenColours(mesh, material);
	return { material, mesh: colours ? { ...bare, colours } : bare };
}

/** The least box about all vertices: its lowest and its highest corner. */
export function boundsOf(positions: Iterable<Float32Array>): { low: number[]; high: number[] } {
	const low = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
	const high = low.map((value) => -value);
	for (const each of positions) {
		for (let i = 0; i < each.length; i += 3) {
			for (let axis = 0; axis < 3; axis++) {
				const value = each[i + axis];
				if (value < low[axis]) low[axis] = value;
				if (value > high[axis]) high[axis] = value;
			}
		}
	}
	return { low, high };
}

/** The longest edge of the box about pieces; 0 where there are none. */
export function extentOf(pieces: readonly Piece[]): number {
	const { low, high } = boundsOf(pieces.map(({ mesh }) => mesh.positions));
	return Math.max(0, ...high.map((value, axis) => value - low[axis]));
}
