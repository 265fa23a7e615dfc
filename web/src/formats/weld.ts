/** Merged equal vertices. */

export interface Welded {
	/** The triangles, by the new vertices, without those that have lost their area because two corners were merged. */
	indices: Uint32Array;
	/** The first old vertex of each new one. */
	from: Uint32Array;
	/** The number of new vertices. */
	count: number;
}

/**
 * Merges vertices whose positions and further values are equal.
 * @param mesh.positions 3 × vertices: equal only to the last bit
 * @param mesh.indices 3 × triangles
 * @param rows further values that must be equal: whole numbers for each vertex, one row after the other
 */
export function welded(
	{ positions, indices }: { positions: Float32Array; indices: Uint32Array },
	...rows: Int32Array[]
): Welded {
	const vertices = positions.length / 3;
	// Adding 0 turns −0 into 0.
	const bits = new Int32Array(Float32Array.from(positions, (value) => value + 0).buffer);
	const keys = interleaved([bits, ...rows], vertices);
	const width = keys.length / (vertices || 1);
	const first = new Uint32Array(vertices);
	const from: number[] = [];
	// A hash table with linear probing, at most half full: new vertices by the hash of all their values.
	const slots = new Int32Array(2 ** Math.ceil(Math.log2(2 * vertices + 2))).fill(-1);
	const isEqual = (one: number, other: number) => {
		for (let k = 0; k < width; k++) if (keys[width * one + k] !== keys[width * other + k]) return false;
		return true;
	};
	for (let vertex = 0; vertex < vertices; vertex++) {
		let slot = hash(keys, width * vertex, width * (vertex + 1)) & (slots.length - 1);
		while (slots[slot] >= 0 && !isEqual(from[slots[slot]], vertex)) slot = (slot + 1) & (slots.length - 1);
		if (slots[slot] < 0) slots[slot] = from.push(vertex) - 1;
		first[vertex] = slots[slot];
	}
	const corners: number[] = [];
	for (let at = 0; at < indices.length; at += 3) {
		const [a, b, c] = [first[indices[at]], first[indices[at + 1]], first[indices[at + 2]]];
		if (a !== b && b !== c && c !== a) corners.push(a, b, c);
	}
	return { indices: Uint32Array.from(corners), from: Uint32Array.from(from), count: from.length };
}

/**
 * Turns rows into one array with all values of a vertex side by side; every row has a multiple of `vertices` values.
 */
function interleaved(rows: readonly Int32Array[], vertices: number): Int32Array {
	const width = rows.reduce((sum, row) => sum + row.length / (vertices || 1), 0);
	const keys = new Int32Array(width * vertices);
	let column = 0;
	for (const row of rows) {
		const rowWidth = row.length / (vertices || 1);
		for (let i = 0; i < row.length; i++) keys[width * Math.floor(i / rowWidth) + column + (i % rowWidth)] = row[i];
		column += rowWidth;
	}
	return keys;
}

/** Returns the hash of the keys `from` … `to` − 1: a 32-bit number from 0. */
function hash(keys: Int32Array, from: number, to: number): number {
	let sum = 0;
	for (let i = from; i < to; i++) sum = Math.imul(sum ^ keys[i], 0x9e3779b1) ^ (sum >>> 15);
	return (sum ^ (sum >>> 13)) >>> 0;
}
