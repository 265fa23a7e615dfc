/** What every model gives back, typed: the plant that scene, exporters and panels read. Metres, +Y up. */

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

/** The modules that were drawn, one each, unmerged; parents come first. */
export interface Segments {
	/** How many there are. */
	count: number;
	/** Index of the segment it grows from, −1 at a root. */
	parent: Int32Array;
	/** Index into `tags`: what it is. */
	tag: Uint32Array;
	/** The model's names for what segments are. */
	tags: readonly string[];
	/** 6 × count: start x y z, end x y z. */
	ends: Float32Array;
	/** 2 × count: radius at the start, at the end. */
	radii: Float32Array;
}

/** What is borne: leaves, fruits, flowers, one mesh many times. */
export interface Organs {
	/** How many there are. */
	count: number;
	/** Index into `tags`: what it is. */
	tag: Uint32Array;
	/** The model's names for what organs are. */
	tags: readonly string[];
	/** Index of the segment that bears it, −1 for none. */
	segment: Int32Array;
	/** Index into `Plant.meshes`, −1 for what has no mesh of its own. */
	mesh: Int32Array;
	/** How much of the sky each sees, as a mean over it: 255 all, 0 none; absent if not asked for. */
	sky?: Uint8Array;
	/** 8 × count: position x y z, rotation as a unit quaternion x y z w, scale. */
	transforms: Float32Array;
}

/** A contiguous run of a mesh with a name of its own. */
export interface MeshRun {
	/** As parts call it. */
	name: string;
	/** Counted from the mesh's first. */
	firstVertex: number;
	/** How many vertices it has. */
	vertexCount: number;
	/** Into `indices`; the indices themselves count from the whole mesh's first vertex. */
	firstIndex: number;
	/** Three for each triangle. */
	indexCount: number;
}

/** A mesh of the plant: what it is made of, and what else is known at each vertex. */
export interface PlantMesh extends Mesh {
	/** What it is of. */
	name: string;
	/** Kind of material: stem, bark, blade, petal, skin … */
	material: string;
	/** What parts it has, where it has more than one. */
	runs: MeshRun[];
	/**
	 * How much of the sky each vertex sees, 255 all, 0 none; of a sheet the better of its sides. Absent if not asked for, and
	 * of a mesh that organs are drawn with: theirs is `Organs.sky`.
	 */
	sky?: Uint8Array;
}

/** A grown plant of any model. Models add what is theirs by extending it. */
export interface Plant {
	/** What was drawn: internodes, branches, veins. */
	segments: Segments;
	/** What is borne. */
	organs: Organs;
	/** What it is drawn with; empty where no meshes were asked for. */
	meshes: PlantMesh[];
	/** By name, in the order of the model. */
	counts: Record<string, number>;
	/** In the order of the model's table of measures; NaN where one does not apply; absent if not asked for. */
	measures?: Float32Array;
	/** What the core has to say about the request, in plain words. */
	notes: string[];
	/** What ended its growth before it was whole: a limit of the core, or the caller's time limit. Absent of a whole plant. */
	cutShort?: "limit" | "time";
	/** 16 hexadecimal digits over segments and organs (docs/fingerprint.md). */
	fingerprint: string;
	/** The same over the meshes; absent if not asked for. */
	meshFingerprint?: string;
	/** How its text was derived; absent if not asked for. */
	trace?: DerivationTrace;
	/** Wall time measured by the caller, in milliseconds. */
	timings: { grow: number };
}

/** Nothing has grown. */
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
