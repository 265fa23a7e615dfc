/**
 * A leaf that another plant bears: baked from a grown one, committed beside this file and read as data, so that no model
 * asks another for it (docs/foliage.md). `npm run generate -- leaves` writes them.
 */
import { type Block, Columns } from "../core/container";

/** Veins as a picture over the square that texture coordinates span, its first row at v = 0. */
export interface Veins {
	/** Pixels to a side. */
	side: number;
	/** side × side, 0 … 255: how much of a pixel is vein. */
	shares: Uint8Array;
}

/** A flat leaf in lengths of its midrib: the petiole joins at the origin, the tip lies near (0, 1). */
export interface AttachedLeaf {
	/** 2 × vertices; the first is the petiole's. */
	points: Float32Array;
	/** By vertex, how far it is from the larger veins: 0 on one … 1 in the midst between them. */
	between: Float32Array;
	/** 2 × vertices: as one sees the upper face with its tip up, u to the right, v down. */
	uvs: Float32Array;
	/** 3 × triangles, counter-clockwise. */
	indices: Uint32Array;
	/** Length and width; absent where whoever bears the leaf has petioles of its own. */
	petiole?: Float32Array;
	/** Absent of leaves that are too small for them. */
	veins?: Veins;
}

/** A leaf as it is committed: where it comes from, and a container (core/container.ts), deflated, in base64. */
export interface LeafFile {
	/** The preset it was baked from: `leaf/grapevine`. */
	from: string;
	data: string;
}

/**
 * The columns of that container: `uvs` (int32 × 2, in STEPS to the square), `between` (uint8, in STEEPS), `indices`
 * (uint32 × 3), `square` (float32: left, bottom and size of the square that the uvs span, in lengths of the midrib),
 * `petiole` (float32: length, width), and `veins` (uint8, rows of pixels).
 */
export const [STEPS, STEEPS] = [1024, 32];

/** @throws where the data is damaged */
export async function readLeaf({ data }: LeafFile): Promise<AttachedLeaf> {
	const packed = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
	const unpacking = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
	const columns = new Columns(new Uint8Array(await new Response(unpacking).arrayBuffer()));
	const [left, bottom, size] = columns.floats("square");
	const uvs = Float32Array.from(columns.ints("uvs"), (value) => value / STEPS);
	const leaf = {
		points: uvs.map((value, at) => (at % 2 === 0 ? left + size * value : bottom + size * (1 - value))),
		between: Float32Array.from(columns.uint8("between"), (value) => value / STEEPS),
		uvs,
		indices: columns.uint32("indices"),
		...(columns.has("petiole") ? { petiole: columns.floats("petiole") } : {}),
	};
	if (!columns.has("veins")) return leaf;
	return { ...leaf, veins: { side: columns.width("veins"), shares: columns.uint8("veins") } };
}

/** As a request has it (wasm-core/src/foliage/flat_leaf.hpp). */
export function leafBlocks({ points, between, uvs, indices, petiole }: AttachedLeaf): Block[] {
	return [
		{ name: "leaf.points", data: points, width: 2 },
		{ name: "leaf.between", data: between },
		{ name: "leaf.uvs", data: uvs, width: 2 },
		{ name: "leaf.triangles", data: indices, width: 3 },
		...(petiole ? [{ name: "leaf.petiole", data: petiole }] : []),
	];
}
