/**
 * A plant in parts: the scene draws and exporters write them, for any model. All in the plant's frame: metres, +Y up.
 */
import type { Material } from "./material";
import type { Mesh } from "./plant";

/** Triangles of one material. */
export interface PartMesh extends Mesh {
	/** The name in files, where it is not its part's: for a mesh with many instances. */
	name?: string;
	/** 3 × vertices, linear light 0 … 1: in place of the material's colour. */
	colours?: Float32Array;
	/** The share of the sky that each vertex sees: 255 all, 0 none; all where absent. */
	sky?: Uint8Array;
	/** For tubes, by vertex: the diameter, metres. Views draw tubes thinner than a pixel wider, so that they are no dashes. */
	widths?: Float32Array;
	/** The model's own number for each triangle, which is picked and highlighted in place of the part. */
	pickIds?: Uint32Array;
	/** 3 × vertices: the fixed points of merged instances that are to sway. */
	feet?: Float32Array;
}

/** Placements of a mesh, one for each of its instances. */
export interface Instances {
	/** 8 × count: position x y z, rotation as a unit quaternion x y z w, scale. */
	transforms: Float32Array;
	/** The mean share of the sky that each sees, where its mesh has none: 255 all, 0 none; all where absent. */
	sky?: Uint8Array;
	/** The name of each instance, where each is a part by itself; without it they are one part together. */
	each?: (index: number) => { name: string; extras?: Extras };
}

/** Properties of a part besides its shape; lengths in metres. */
export type Extras = Record<string, unknown>;

/** Parts share meshes, arrays and materials by sharing the objects, which never change. */
export interface Part {
	/** The name for users: `Leaf 2`. Unique among all parts of a plant. */
	name: string;
	/** Absent for a group. */
	shape?: Shape;
	/** Further properties. */
	extras?: Extras;
	/** Parts that move with it. */
	children?: readonly Part[];
}

export type Vector = [x: number, y: number, z: number];

/** Detail of a surface finer than its vertices, sampled at any point. */
export interface SurfaceDetail {
	/** Whether it has finer normals, too. */
	readonly relief: boolean;
	/** The detail at a point between three of the mesh's vertices, by weights that sum to 1. */
	at(corners: readonly number[], weights: readonly number[]): DetailSample;
}

export interface DetailSample {
	/** 0 mirror … 1 matt. */
	roughness: number;
	/** In the mesh's frame, of unit length; with a relief only. */
	normal?: Vector;
}

/** The visible shape of a part. */
export interface Shape {
	/** In the plant's frame, or, with `instances`, in its own. */
	mesh: PartMesh;
	material: Material;
	/** Placements, where the mesh is drawn more than once. */
	instances?: Instances;
	/** The fixed point, which it turns about; the origin where absent. Not with `instances`. */
	centre?: readonly [x: number, y: number, z: number];
	/**
	 * The transform (as in `Instances`) from a unit-sized body that faces +Y to this body, for bodies of one material
	 * that resemble each other. Files with instances draw one mesh for all of them.
	 */
	pose?: Float32Array;
	/** For files that hold detail in pictures; loads its sampler. */
	loadDetail?: () => Promise<SurfaceDetail>;
	/**
	 * For readers without vertex colours: parts of one material and one variant are written in the mean of their
	 * colours. Without it they have the material's.
	 */
	variant?: string;
}

/** Numbers of one transform. */
export const TRANSFORM = 8;

/** Yields every part, parents before their children. */
export function* everyPart(parts: Iterable<Part>): Generator<Part> {
	for (const part of parts) {
		yield part;
		if (part.children) yield* everyPart(part.children);
	}
}

/** A contiguous run of vertices and triangles; its indices count from the whole mesh's first vertex. */
export interface VertexRun {
	firstVertex: number;
	vertexCount: number;
	firstIndex: number;
	indexCount: number;
}

/** Returns a run of a mesh as a mesh of its own; its indices count from its first vertex. */
export function cut(mesh: PartMesh, { firstVertex, vertexCount, firstIndex, indexCount }: VertexRun): PartMesh {
	const lastVertex = firstVertex + vertexCount;
	const colours = mesh.colours?.subarray(3 * firstVertex, 3 * lastVertex);
	const sky = mesh.sky?.subarray(firstVertex, lastVertex);
	const widths = mesh.widths?.subarray(firstVertex, lastVertex);
	return {
		positions: mesh.positions.subarray(3 * firstVertex, 3 * lastVertex),
		normals: mesh.normals.subarray(3 * firstVertex, 3 * lastVertex),
		uvs: mesh.uvs.subarray(2 * firstVertex, 2 * lastVertex),
		indices: countedFrom(firstVertex, mesh.indices.subarray(firstIndex, firstIndex + indexCount)),
		...(colours ? { colours } : {}),
		...(sky ? { sky } : {}),
		...(widths ? { widths } : {}),
	};
}

/**
 * Returns indices that count from another vertex. A plain loop: `map` takes ten times as long, and a plant may have
 * millions.
 * @param first number of the vertex that becomes 0
 */
function countedFrom(first: number, indices: Uint32Array): Uint32Array {
	if (first === 0) return indices;
	const counted = new Uint32Array(indices.length);
	for (let i = 0; i < indices.length; i++) counted[i] = indices[i] - first;
	return counted;
}
