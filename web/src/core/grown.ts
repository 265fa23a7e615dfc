/**
 * What a growth gives back: plain typed arrays copied out of the core, in metres, +Y up, the bunch hanging
 * down from p1 at the origin; p3 is +X, p4 −X, p5 +Z, p6 −Z. Scene, exporters, panels and the command line all
 * read this one shape; none of them computes botany. The layout in bytes is in wasm_api/panicle.h.
 */

/** Kinds of internode, by code: `INTERNODE_KINDS[kind[i]]`. */
export const INTERNODE_KINDS = ["rachis", "axis", "end", "pedicel"] as const;
export type InternodeKind = (typeof INTERNODE_KINDS)[number];

/** States of internode, by code. */
export const INTERNODE_STATES = ["grown", "withered"] as const;
export type InternodeState = (typeof INTERNODE_STATES)[number];

/** One side of the profile: what the person drew (pixels) and what the grammar gets (counts). */
export interface PlanSide {
	w: number;
	r: number;
	n: number;
	rd: number;
}

/** The parameters of the grammar that follow from the profile (paper section 4.2). */
export interface Plan {
	/** Rachis segments. */
	m: number;
	/** p3, p4, p5, p6. */
	sides: [PlanSide, PlanSide, PlanSide, PlanSide];
	/** n(0) … n(m−2), from the top axis to the one nearest the tip. */
	axes: number[];
}

export interface Counts {
	endStructures: number;
	internodes: number;
	pedicels: number;
	berries: number;
	withered: number;
	/** Internodes that found no room and were cut with all they would have borne. */
	cut: number;
}

/** The skeleton; parents come first. */
export interface Internodes {
	count: number;
	/** Index of the parent internode, −1 at the root. */
	parent: Int32Array;
	kind: Uint8Array;
	/** First-order axis s (0 at the top; a second bunch's go on after the first's), −1 for the rachis. */
	axis: Int32Array;
	state: Uint8Array;
	/** 6 × count: start x y z, end x y z. */
	ends: Float32Array;
	/** 2 × count: radius at the start, at the end. */
	radii: Float32Array;
}

export interface Berries {
	count: number;
	/** 4 × count: centre x y z, radius. */
	spheres: Float32Array;
	/** 3 × count: unit vector from the pedicel towards the tip scar. */
	directions: Float32Array;
	/** Index of the pedicel's internode. */
	parent: Int32Array;
}

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

/** A contiguous run of the stem mesh: the rachis (axis −1) or one first-order axis with its pedicels. */
export interface StemPart {
	axis: number;
	firstVertex: number;
	vertexCount: number;
	/** Into `indices`; the indices themselves count from the whole mesh's first vertex. */
	firstIndex: number;
	indexCount: number;
}

export interface StemMesh extends Mesh {
	/** The internode each vertex belongs to. */
	internode: Uint32Array;
	parts: StemPart[];
}

export interface Grown {
	plan: Plan;
	/** The second bunch's plan, where there is one. */
	second?: Plan;
	counts: Counts;
	internodes: Internodes;
	berries: Berries;
	/** Absent when only the skeleton was asked for. */
	stem?: StemMesh;
	/** The one mesh all berries share: unit radius, centred, tip scar towards +Y. */
	berry?: Mesh;
	/** What the core has to say about the request, in plain words. */
	notes: string[];
	/** 16 hexadecimal digits over skeleton and organs (docs/fingerprint.md). */
	fingerprint: string;
	/** The same over the meshes; may change from version to version. */
	meshFingerprint?: string;
	/** Wall time measured by the caller, in milliseconds. */
	timings: { grow: number };
}
