/** The plant that every model returns, for scene, exporters and panels. Metres, +Y up. */

import type { Message } from "../locale/texts";
import type { DerivationTrace } from "./derivation_trace";

/** Triangles; normals are of unit length, indices go counter-clockwise seen from outside. */
export interface Mesh {
	/** 3 × vertices. */
	positions: Float32Array;
	/** 3 × vertices. */
	normals: Float32Array;
	/** 2 × vertices. */
	uvs: Float32Array;
	/** 3 × triangles. */
	indices: Uint32Array;
}

/** The drawn modules, one each, unmerged; parents come first. */
export interface Segments {
	count: number;
	/** Index of the parent segment, −1 at a root. */
	parent: Int32Array;
	/** Index into `tags`: the kind of segment. */
	tag: Uint32Array;
	/** The model's names for kinds of segments. */
	tags: readonly string[];
	/** 6 × count: start x y z, end x y z. */
	ends: Float32Array;
	/** 2 × count: radius at the start, at the end. */
	radii: Float32Array;
}

/** Attached organs: leaves, fruits, flowers, as instances of meshes. */
export interface Organs {
	count: number;
	/** Index into `tags`: the kind of organ. */
	tag: Uint32Array;
	/** The model's names for kinds of organs. */
	tags: readonly string[];
	/** Index of the segment that it is attached to, −1 for none. */
	segment: Int32Array;
	/** Index into `Plant.meshes`, −1 for organs without a mesh of their own. */
	mesh: Int32Array;
	/** The mean share of the sky that each sees: 255 all, 0 none; absent if not requested. */
	sky?: Uint8Array;
	/** 8 × count: position x y z, rotation as a unit quaternion x y z w, scale. */
	transforms: Float32Array;
}

/** A contiguous run of a mesh with a name of its own. */
export interface MeshRun {
	/** The name of the part. */
	name: string;
	/** Index of its first vertex in the mesh. */
	firstVertex: number;
	vertexCount: number;
	/** Index into `indices`; the indices themselves count from the whole mesh's first vertex. */
	firstIndex: number;
	/** Three per triangle. */
	indexCount: number;
}

/** A mesh of the plant: its material, and values at each vertex. */
export interface PlantMesh extends Mesh {
	/** The name in the model. */
	name: string;
	/** Kind of material: stem, bark, blade, petal, skin … */
	material: string;
	/** Its parts, where it has more than one. */
	runs: MeshRun[];
	/**
	 * The share of the sky that each vertex sees, 255 all, 0 none; for a sheet the better of its sides. Absent if not
	 * requested, and for a mesh of organs: theirs is `Organs.sky`.
	 */
	sky?: Uint8Array;
}

/** A grown plant of any model. Models extend it with their own data. */
export interface Plant {
	/** Internodes, branches, veins. */
	segments: Segments;
	/** Leaves, fruits, flowers. */
	organs: Organs;
	/** Empty if not requested. */
	meshes: PlantMesh[];
	/** By name, in the order of the model. */
	counts: Record<string, number>;
	/** In the order of the model's table of measures; NaN where one does not apply; absent if not requested. */
	measures?: Float32Array;
	/** Messages of the core about the request, in plain words. */
	notes: string[];
	/** Those notes that have codes, with their arguments; absent where none has. */
	noteMessages?: readonly Message[];
	/** The limit that ended growth early: one of the core, or the caller's time limit. Absent for a whole plant. */
	cutShort?: "limit" | "time";
	/** 16 hexadecimal digits over segments and organs (docs/fingerprint.md). */
	fingerprint: string;
	/** The same over the meshes; absent if not requested. */
	meshFingerprint?: string;
	/** The trace of the text's derivation; absent if not requested. */
	trace?: DerivationTrace;
	/** Wall time measured by the caller, in milliseconds. */
	timings: { grow: number };
}

/** A plant without any parts. */
export const EMPTY_PLANT: Plant = {
	segments: {
		count: 0,
		parent: new Int32Array(0),
		tag: new Uint32Array(0),
		tags: [],
		ends: new Float32Array(0),
		radii: new Float32Array(0),
	},
	organs: {
		count: 0,
		tag: new Uint32Array(0),
		tags: [],
		segment: new Int32Array(0),
		mesh: new Int32Array(0),
		transforms: new Float32Array(0),
	},
	meshes: [],
	counts: {},
	notes: [],
	fingerprint: "",
	timings: { grow: 0 },
};
