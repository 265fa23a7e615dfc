/**
 * A plant in parts: what the scene draws and exporters write, whatever the model. All in the plant's frame: metres, +Y
 * up.
 */
import type { Material } from "./material";
import type { Mesh } from "./plant";

/** Triangles of one material. */
export interface PartMesh extends Mesh {
	/** As files call it, where it is not its part's name: of a mesh that many draw. */
	name?: string;
	/** 3 × vertices, linear light 0 … 1: in place of the material's colour. */
	colours?: Float32Array;
	/** How much of the sky each vertex sees: 255 all, 0 none; all where absent. */
	sky?: Uint8Array;
	/** What each triangle is of, by the model's own numbers: it is picked and marked in place of the part. */
	cells?: Uint32Array;
	/** 3 × vertices: where each is held, of instances that have been put together and are to sway. */
	feet?: Float32Array;
}

/** Where a mesh stands: once for each of its instances. */
export interface Instances {
	/** 8 × count: position x y z, rotation as a unit quaternion x y z w, scale. */
	transforms: Float32Array;
	/** How much of the sky each sees in the mean, where its mesh does not say: 255 all, 0 none; all where absent. */
	sky?: Uint8Array;
	/** What each is called, where each is a part by itself; without it they are the part together. */
	each?: (index: number) => { name: string; extras?: Extras };
}

/** What is known of a part besides its shape; lengths in metres. */
export type Extras = Record<string, unknown>;

/** Parts share meshes, arrays and materials by sharing the objects; nothing in them is ever changed. */
export interface Part {
	/** As people call it: `Leaf 2`. One of a kind among all parts of a plant. */
	name: string;
	/** Absent for a mere group. */
	shape?: Shape;
	/** What is known of it besides. */
	extras?: Extras;
	/** Move with it. */
	children?: readonly Part[];
}

export type Vector = [x: number, y: number, z: number];

/** What of a surface is finer than its vertices, wherever one asks. */
export interface Finer {
	/** Whether its normals are finer, too. */
	readonly relief: boolean;
	/** What there is at a place among three of the mesh's vertices, by weights that sum to 1. */
	at(corners: readonly number[], weights: readonly number[]): Fine;
}

export interface Fine {
	/** 0 mirror … 1 matt. */
	roughness: number;
	/** In the mesh's frame, of unit length; of what has a relief. */
	normal?: Vector;
}

/** What is to be seen of a part. */
export interface Shape {
	/** Where it stands, or, with `instances`, in its own frame. */
	mesh: PartMesh;
	/** What it is made of. */
	material: Material;
	/** Where it stands, where it does more than once. */
	instances?: Instances;
	/** Where it is held and turned about; the origin where absent. Not with `instances`. */
	centre?: readonly [x: number, y: number, z: number];
	/**
	 * Of a body like others of its material: what takes one of unit size that faces +Y to it (a transform, as of `Instances`).
	 * Files with instances draw one for all that are alike.
	 */
	pose?: Float32Array;
	/** For files that say it in pictures; what tells it is fetched then. */
	finer?: () => Promise<Finer>;
	/**
	 * For readers that know no colours of vertices: parts of one material and one variant are written in the mean of their
	 * colours. Without it they have the material's.
	 */
	variant?: string;
}

/** Numbers of one transform. */
export const TRANSFORM = 8;

/** Every part, parents before their children. */
export function* everyPart(parts: Iterable<Part>): Generator<Part> {
	for (const part of parts) {
		yield part;
		if (part.children) yield* everyPart(part.children);
	}
}

/** A contiguous run of vertices and triangles, its indices counted from the whole mesh's first vertex. */
export interface Run {
	firstVertex: number;
	vertexCount: number;
	firstIndex: number;
	indexCount: number;
}

/** One run of a mesh as a mesh of its own, indices counted from its first vertex. */
export function cut(mesh: PartMesh, { firstVertex, vertexCount, firstIndex, indexCount }: Run): PartMesh {
	const lastVertex = firstVertex + vertexCount;
	const colours = mesh.colours?.subarray(3 * firstVertex, 3 * lastVertex);
	const sky = mesh.sky?.subarray(firstVertex, lastVertex);
	return {
		positions: mesh.positions.subarray(3 * firstVertex, 3 * lastVertex),
		normals: mesh.normals.subarray(3 * firstVertex, 3 * lastVertex),
		uvs: mesh.uvs.subarray(2 * firstVertex, 2 * lastVertex),
		indices: countedFrom(firstVertex, mesh.indices.subarray(firstIndex, firstIndex + indexCount)),
		...(colours ? { colours } : {}),
		...(sky ? { sky } : {}),
	};
}

/** Indices counted from another vertex. By a plain loop: `map` takes ten times as long, and a plant may have millions. */
function countedFrom(first: number, indices: Uint32Array): Uint32Array {
	if (first === 0) return indices;
	const counted = new Uint32Array(indices.length);
	for (let i = 0; i < indices.length; i++) counted[i] = indices[i] - first;
	return counted;
}
