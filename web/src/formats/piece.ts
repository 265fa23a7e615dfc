/** Pieces: all drawn meshes of a plant in its frame, from which light forms of a file are made. */
import type { Material } from "../plant/material";
import {
	type Extras,
	everyPart,
	type Instances,
	type Part,
	type PartMesh,
	type Shape,
	TRANSFORM,
	type Vector,
} from "../plant/part";
import { placed } from "./together";
import { writtenColours } from "./vertex_colours";

/** Triangles of one material in the plant's frame; their colours include the shade. */
export interface Piece {
	material: Material;
	mesh: PartMesh;
}

/** A piece that is a part, or an instance where each is a part by itself. */
export interface NamedPiece extends Piece {
	/** The name of the part. */
	name: string;
	/** Properties of the part. */
	extras?: Extras;
}

/**
 * Yields every mesh, and every instance by itself, in the plant's frame.
 * @param still the fixed point of still parts: then instances, too, have fixed points (`feet`)
 */
export function* piecesOf(parts: Iterable<Part>, still?: Vector): Generator<NamedPiece> {
	for (const part of everyPart(parts)) {
		const { shape } = part;
		if (shape?.instances) yield* instancesOf(part, shape, shape.instances, still);
		else if (shape)
			yield piece(part, still && shape.material.still ? { ...shape, mesh: heldAt(still, shape.mesh) } : shape);
	}
}

/**
 * Yields every instance of a part as a piece in the plant's frame, in its own share of the sky.
 * @param still where given, each instance is fixed at its own origin (`feet`)
 */
function* instancesOf(
	part: Part,
	{ mesh, material }: Shape,
	{ transforms, sky, each }: Instances,
	still: Vector | undefined,
): Generator<NamedPiece> {
	for (let i = 0; i < transforms.length / TRANSFORM; i++) {
		const { positions, normals } = placed(mesh, transforms.subarray(TRANSFORM * i, TRANSFORM * (i + 1)));
		const bare: PartMesh = { ...mesh, positions: Float32Array.from(positions), normals: Float32Array.from(normals) };
		const [x, y, z] = transforms.subarray(TRANSFORM * i, TRANSFORM * i + 3);
		const own = still ? heldAt([x, y, z], bare) : bare;
		if (sky) own.sky = new Uint8Array(positions.length / 3).fill(sky[i]);
		yield piece(each?.(i) ?? part, { mesh: own, material });
	}
}

/** Returns the mesh with one fixed point for all vertices (`feet`). */
function heldAt(place: Vector, mesh: PartMesh): PartMesh {
	return { ...mesh, feet: mesh.positions.map((_, at) => place[at % 3]) };
}

/** Makes a piece of a mesh, with vertex colours that include the shade. */
function piece(
	{ name, extras }: Pick<Part, "name" | "extras">,
	{ mesh, material }: Pick<Shape, "mesh" | "material">,
): NamedPiece {
	const { sky: _, colours: __, ...bare } = mesh;
	const colours = writtenColours(mesh, material);
	return { name, ...(extras && { extras }), material, mesh: colours ? { ...bare, colours } : bare };
}

/** Returns the bounding box of all vertices: its lowest and its highest corner. */
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

/** Returns the longest edge of the pieces' bounding box; 0 where there are none. */
export function extentOf(pieces: readonly Piece[]): number {
	const { low, high } = boundsOf(pieces.map(({ mesh }) => mesh.positions));
	return Math.max(0, ...high.map((value, axis) => value - low[axis]));
}
