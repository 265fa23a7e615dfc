/**
 * A bunch, in addition to a plant: plain typed arrays copied out of the core, in metres, +Y up. The bunch hangs down
 * from p1 at the origin; p3 is +X, p4 −X, p5 +Z, p6 −Z. wasm-core/src/models/bunch/model.hpp lists the columns.
 */
import type { Veins } from "../../plant/leaf";
import type { VertexRun } from "../../plant/part";
import type { Mesh, Plant } from "../../plant/plant";

export type { Mesh };

/** Kinds of internode, by code: `INTERNODE_KINDS[kind[i]]`. */
export const INTERNODE_KINDS = ["rachis", "axis", "end", "pedicel"] as const;
export type InternodeKind = (typeof INTERNODE_KINDS)[number];

/** States of internode, by code. */
export const INTERNODE_STATES = ["grown", "withered"] as const;
export type InternodeState = (typeof INTERNODE_STATES)[number];

export const PROCEDURES = ["paper", "natural"] as const;
export type Procedure = (typeof PROCEDURES)[number];

/** Kinds of fruit, by code; each has its own surface. */
export const FRUITS = ["grape", "currant", "bramble", "lychee", "longan", "duku"] as const;
export type Fruit = (typeof FRUITS)[number];

/**
 * Reasons why a pedicel has no berry, by code: not set (more flowers than requested berries), no room, outside, by
 * hand.
 */
export const THINNED_WHY = ["", "not set", "no room", "outside", "by hand"] as const;

/** Shape shared by the berries of a bunch (models/bunch/berry/berry_body.hpp). */
export interface BerryForm {
	fruit: Fruit;
	/** −1 … 1: below 0 the pedicel's end is wider, above 0 the tip. */
	taper: number;
	/** 0 … 1: from an ellipse to a cylinder with round ends. */
	blunt: number;
	/** 0 … 1: from straight to bent like a horn. */
	curve: number;
}

/** One side of the profile: the drawn lengths `w` and `r` (pixels), and the grammar's counts `n` and `rd`. */
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

/** Profile that a bunch fills, in pixels: the handles' profile, varied by the seed. */
export type OwnProfile = Record<"l" | `p${3 | 4 | 5 | 6}${"w" | "r"}`, number>;

/** Counts by name; a type alias, so that it is assignable to a record. */
export type Counts = {
	endStructures: number;
	internodes: number;
	pedicels: number;
	berries: number;
	withered: number;
	/** Internodes without room, which were cut with all their descendants. */
	cut: number;
};

/** The skeleton; parents come first. */
export interface Internodes {
	count: number;
	/** Index of the parent internode, −1 at the root. */
	parent: Int32Array;
	kind: Uint32Array;
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
	/** 4 × count: centre x y z, radius of the ball of the berry's volume. */
	spheres: Float32Array;
	/** 3 × count: unit vector from the pedicel towards the tip scar. */
	directions: Float32Array;
	/** Internode of the pedicel. */
	parent: Int32Array;
	/** Below 2^30; the same while handles move. `thinned` of a specimen lists those taken off by hand. */
	ids: Uint32Array;
	/** TRAITS.length × count, in the order of `TRAITS`. */
	traits: Float32Array;
}

/**
 * Traits of a berry besides its place: whole width and length in metres; exposure to the sun 0 … 1; turned 0 (unripe
 * colour) … 1 (ripe colour); opened 0 (closed bud) … 1; set 0 (open flower with stamens) … 1 (berry); shrivel 0 … 1;
 * seeds 0 … 4.
 */
export const TRAITS = ["width", "length", "exposure", "turned", "opened", "set", "shrivel", "seeds"] as const;
export type Trait = (typeof TRAITS)[number];

/** A missing berry. */
export interface Thinned {
	id: number;
	why: (typeof THINNED_WHY)[number];
	/** Where its pedicel begins, metres. */
	place: [x: number, y: number, z: number];
}

/**
 * Surfaces of the individual berries, flattened where they touch. All share one pattern of vertices: berry i has those
 * from i × V on, V = uvs.length / 2; uvs and indices (0 … V − 1) serve every berry.
 */
export interface BerrySurfaces {
	/** 2 × V: u round, v from the pedicel's seat (0) to the tip scar (1). */
	uvs: Float32Array;
	/** 3 × triangles of one berry. */
	indices: Uint32Array;
	/** 3 × V × berries, metres. */
	positions: Float32Array;
	/** 3 × V × berries. */
	normals: Float32Array;
	/** V × berries: 0 free … 255 in contact with a neighbour, where bloom is rubbed off. */
	pressed: Uint8Array;
	/** V × berries: sky visibility of each vertex, 255 all, 0 none; absent if not requested. */
	sky?: Uint8Array;
}

/** The one mesh shared by all berries of the paper's procedure: unit radius, centred, tip scar towards +Y. */
export interface SharedBerry extends Mesh {
	/** V × berries, as in `BerrySurfaces`: for V vertices of this mesh at each berry (plant/orientation.ts). */
	sky?: Uint8Array;
}

export const FOLIAGE_KINDS = ["cane", "leaf", "petiole"] as const;

/** A contiguous run of the foliage's mesh. */
export interface FoliagePart {
	kind: (typeof FOLIAGE_KINDS)[number];
	firstVertex: number;
	vertexCount: number;
	firstIndex: number;
	indexCount: number;
}

export interface Foliage extends Mesh {
	parts: FoliagePart[];
	/** Sky visibility of each vertex, 255 all, 0 none; of a leaf the better of its sides. Absent if not requested. */
	sky?: Uint8Array;
	/** Veins of every leaf, in its texture coordinates; absent without leaves. */
	veins?: Veins;
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
	/** Sky visibility of each vertex, 255 all, 0 none; absent if not requested. */
	sky?: Uint8Array;
}

/** Pieces of a flower, each a run of the flower's mesh (wasm-core/src/models/bunch/berry/flower.hpp). */
export const FLOWER_PIECES = ["stamens", "cap", "pistil", "petals", "calyx"] as const;
export type FlowerPiece = (typeof FLOWER_PIECES)[number];

/** Mesh around an ovary of unit radius facing +Y; a calyx is placed at its berry's seat. */
export interface FlowerMesh extends Mesh {
	pieces: (VertexRun & { piece: FlowerPiece })[];
	/** Scale of the mesh in metres: an ovary's radius. */
	unit: number;
}

export interface BunchPlant extends Plant {
	procedure: Procedure;
	form: BerryForm;
	/** Profile of the seed; natural procedure only. */
	profile?: OwnProfile;
	/** Plan of the handles' profile. */
	plan: Plan;
	/** Plan of the second bunch, if any. */
	second?: Plan;
	counts: Counts;
	internodes: Internodes;
	berries: Berries;
	/** Absent if only the skeleton was requested. */
	stem?: StemMesh;
	/** Absent for the natural procedure. */
	berry?: SharedBerry;
	/** Individual berry surfaces; absent for the paper's procedure, which places `berry` at the spheres. */
	surfaces?: BerrySurfaces;
	/** Present if a berry's trait `set` is below 1, or if fruits keep a calyx. */
	flower?: FlowerMesh;
	/** Leaves and cane, if requested. */
	foliage?: Foliage;
	/** Missing berries with reasons; natural procedure only. */
	thinned: Thinned[];
}
