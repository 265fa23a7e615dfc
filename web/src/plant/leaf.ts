/**
 * A leaf of another plant: baked from a grown one, committed beside this file and read as data, so that models do not
 * depend on the leaf model (docs/foliage.md). `npm run generate -- leaves` writes them.
 */
import { type Block, Columns } from "../core/container";

/** Veins as a picture over the square of texture coordinates; its first row is at v = 0. */
export interface Veins {
	/** Pixels per side. */
	side: number;
	/** side × side, 0 … 255: the share of veins in a pixel. */
	shares: Uint8Array;
}

/** A flat leaf in lengths of its midrib: the petiole joins at the origin, the tip is near (0, 1). */
export interface AttachedLeaf {
	/** 2 × vertices; the first is the petiole's. */
	points: Float32Array;
	/** By vertex, the distance from the larger veins: 0 on one … 1 midway between two. */
	between: Float32Array;
	/** 2 × vertices: the upper face seen with its tip up, u to the right, v down. */
	uvs: Float32Array;
	/** 3 × triangles, counter-clockwise. */
	indices: Uint32Array;
	/** Length and width; absent where the plant has petioles of its own. */
	petiole?: Float32Array;
	/** Absent for leaves that are too small for veins. */
	veins?: Veins;
}

/** A committed leaf: its source, and a container (core/container.ts), deflated, in base64. */
export interface LeafFile {
	/** The preset that was baked: `leaf/grapevine`. */
	from: string;
	data: string;
}

/**
 * Scales of the container's columns: `uvs` (int32 × 2, in UV_STEPS to the square), `between` (uint8, in BETWEEN_STEPS),
 * `indices` (uint32 × 3), `square` (float32: left, bottom and size of the square of the uvs, in lengths of the midrib),
 * `petiole` (float32: length, width), and `veins` (uint8, rows of pixels).
 */
export const [UV_STEPS, BETWEEN_STEPS] = [1024, 32];

/**
 * Reads a leaf from its file.
 * @throws where the data is damaged
 */
export async function readLeaf({ data }: LeafFile): Promise<AttachedLeaf> {
	const packed = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
	const unpacking = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
	const columns = new Columns(new Uint8Array(await new Response(unpacking).arrayBuffer()));
	const [left, bottom, size] = columns.floats("square");
	const uvs = Float32Array.from(columns.ints("uvs"), (value) => value / UV_STEPS);
	const leaf = {
		points: uvs.map((value, at) => (at % 2 === 0 ? left + size * value : bottom + size * (1 - value))),
		between: Float32Array.from(columns.uint8("between"), (value) => value / BETWEEN_STEPS),
		uvs,
		indices: columns.uint32("indices"),
		...(columns.has("petiole") ? { petiole: columns.floats("petiole") } : {}),
	};
	if (!columns.has("veins")) return leaf;
	return { ...leaf, veins: { side: columns.width("veins"), shares: columns.uint8("veins") } };
}

/** Returns the leaf as columns of a request (wasm-core/src/foliage/flat_leaf.hpp). */
export function leafBlocks({ points, between, uvs, indices, petiole }: AttachedLeaf): Block[] {
	return [
		{ name: "leaf.points", data: points, width: 2 },
		{ name: "leaf.between", data: between },
		{ name: "leaf.uvs", data: uvs, width: 2 },
		{ name: "leaf.triangles", data: indices, width: 3 },
		...(petiole ? [{ name: "leaf.petiole", data: petiole }] : []),
	];
}
