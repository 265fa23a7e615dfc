/**
 * Removes hidden triangles: those inside closed meshes, such as the ends of twigs inside attached organs and parent
 * branches, and those where closed meshes touch face to face.
 */
import type { Mesh } from "../plant/plant";
import { boundsOf, type Piece } from "./piece";
import { welded } from "./weld";

/** Finds points of a plant's surface that its closed pieces hide. */
export class Cover<Own extends Piece> {
	readonly #pieces: readonly Own[];
	readonly #gap: number;
	/** For each piece, the closed ones near it. */
	readonly #bodiesNear: readonly (readonly Body[])[];

	/**
	 * @param gap metres: a surface is hidden, too, where a body is in front of it at up to this distance. Points are moved
	 * outwards by the gap before they are tested, so that surfaces that only touch hide each other.
	 */
	constructor(pieces: readonly Own[], gap: number) {
		const boxes = pieces.map(({ mesh }) => boundsOf([mesh.positions]));
		const closed = new Map<Uint32Array, boolean>();
		const bodies = pieces.flatMap(({ mesh }, i) => {
			// Meshes that share triangles are closed, or open, together.
			const whole = closed.get(mesh.indices) ?? isClosed(mesh);
			closed.set(mesh.indices, whole);
			return whole ? [new Body(mesh, boxes[i])] : [];
		});
		this.#pieces = pieces;
		this.#gap = gap;
		this.#bodiesNear = boxes.map((box) => bodies.filter((body) => overlap(body.box, box, gap)));
	}

	/** Returns the pieces without hidden triangles; wholly hidden pieces are left out. */
	visible(): Own[] {
		return this.#pieces.flatMap((piece, i) => {
			if (this.#bodiesNear[i].length === 0) return [piece];
			const indices = visibleTriangles(piece.mesh, this.#bodiesNear[i], this.#gap);
			return indices.length > 0 ? [{ ...piece, mesh: { ...piece.mesh, indices } }] : [];
		});
	}

	/**
	 * Returns whether a point on the surface of the piece of that index is hidden.
	 * @param place the point, metres
	 * @param normal of unit length
	 */
	hides(index: number, place: readonly number[], normal: readonly number[]): boolean {
		const [x, y, z] = place.map((value, k) => value + this.#gap * normal[k]);
		return this.#bodiesNear[index].some((body) => body.holds(x, y, z));
	}
}

/** Returns the pieces without hidden triangles (`Cover`). */
export function withoutHidden<Own extends Piece>(pieces: readonly Own[], gap: number): Own[] {
	return new Cover(pieces, gap).visible();
}

/**
 * Returns the vertex indices of the triangles that are not hidden, 3 each: at least one corner, or the middle, is
 * outside of all bodies when moved outwards, along the normals, by the gap.
 * @param bodies the closed bodies near the mesh
 * @param gap metres, as in `Cover`
 */
function visibleTriangles({ positions, normals, indices }: Mesh, bodies: readonly Body[], gap: number): Uint32Array {
	const inside = (x: number, y: number, z: number) => bodies.some((body) => body.holds(x, y, z));
	const shifted = positions.map((value, i) => value + gap * normals[i]);
	const hidden = new Uint8Array(positions.length / 3);
	for (let v = 0; v < hidden.length; v++)
		hidden[v] = Number(inside(shifted[3 * v], shifted[3 * v + 1], shifted[3 * v + 2]));
	const visible: number[] = [];
	for (let at = 0; at < indices.length; at += 3) {
		const [a, b, c] = [indices[at], indices[at + 1], indices[at + 2]];
		const middle = (k: number) => (shifted[3 * a + k] + shifted[3 * b + k] + shifted[3 * c + k]) / 3;
		// Test the middle, too: the covering bodies need not be convex.
		const covered = hidden[a] && hidden[b] && hidden[c] && inside(middle(0), middle(1), middle(2));
		if (!covered) visible.push(a, b, c);
	}
	return Uint32Array.from(visible);
}

interface Box {
	low: readonly number[];
	high: readonly number[];
}

/** Returns whether two boxes are at most `margin` apart along every axis. */
const overlap = (one: Box, other: Box, margin: number) =>
	[0, 1, 2].every((k) => one.low[k] <= other.high[k] + margin && other.low[k] <= one.high[k] + margin);

/**
 * Returns whether every edge has a triangle on either side, where equal positions are one corner: each edge is then
 * passed as often in one direction as in the other.
 */
export function isClosed(mesh: Mesh): boolean {
	const { indices, count } = welded({ positions: mesh.positions, indices: mesh.indices });
	const edges = new Map<number, number>();
	for (let at = 0; at < indices.length; at += 3) {
		for (let k = 0; k < 3; k++) {
			const [from, to] = [indices[at + k], indices[at + ((k + 1) % 3)]];
			const key = Math.min(from, to) * count + Math.max(from, to);
			edges.set(key, (edges.get(key) ?? 0) + Math.sign(to - from));
		}
	}
	return edges.size > 0 && [...edges.values()].every((sum) => sum === 0);
}

/** Columns of the grid across a body's box; rays run along x. */
const COLUMNS = 12;
/** Shares of the box by which points are shifted, so that no ray runs along an edge of a symmetrical body. */
const RAY_SHIFT = [1.7e-6, 2.3e-6] as const;

/** The inside of a closed mesh, by the winding number of its surface along a ray in the direction of x. */
class Body {
	readonly #positions: Float32Array;
	/** Corners of the triangles that a ray of each column may meet. */
	readonly #columns: number[][] = Array.from({ length: COLUMNS * COLUMNS }, () => []);

	/** @param box the bounds of the mesh */
	constructor(
		{ positions, indices }: Mesh,
		readonly box: Box,
	) {
		this.#positions = positions;
		for (let at = 0; at < indices.length; at += 3) {
			const corners = [indices[at], indices[at + 1], indices[at + 2]];
			const [y0, y1] = this.#range(corners, 1);
			const [z0, z1] = this.#range(corners, 2);
			for (let y = y0; y <= y1; y++) {
				for (let z = z0; z <= z1; z++) this.#columns[y * COLUMNS + z].push(...corners);
			}
		}
	}

	/**
	 * Returns whether a point is inside: the ray from it along +x crosses the surface outwards and inwards unequally
	 * often.
	 */
	holds(x: number, y: number, z: number): boolean {
		const { low, high } = this.box;
		if (x <= low[0] || x >= high[0] || y <= low[1] || y >= high[1] || z <= low[2] || z >= high[2]) return false;
		const [ry, rz] = [y + RAY_SHIFT[0] * (high[1] - low[1]), z + RAY_SHIFT[1] * (high[2] - low[2])];
		const corners = this.#columns[this.#column(ry, 1) * COLUMNS + this.#column(rz, 2)];
		let turns = 0;
		for (let at = 0; at < corners.length; at += 3) {
			turns += this.#crossing(3 * corners[at], 3 * corners[at + 1], 3 * corners[at + 2], x, ry, rz);
		}
		return turns !== 0;
	}

	/**
	 * Returns ±1 if the ray from the point along +x meets a triangle, by the side that it comes from; else 0. The signs
	 * of the barycentric coordinates u, v, w in the y–z plane decide whether the ray passes through the triangle.
	 * @param a @param b @param c offsets of its corners in the positions
	 */
	#crossing(a: number, b: number, c: number, x: number, y: number, z: number): number {
		const p = this.#positions;
		const ay = p[a + 1] - y;
		const az = p[a + 2] - z;
		const by = p[b + 1] - y;
		const bz = p[b + 2] - z;
		const cy = p[c + 1] - y;
		const cz = p[c + 2] - z;
		const u = by * cz - bz * cy;
		const v = cy * az - cz * ay;
		const w = ay * bz - az * by;
		const inside = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
		if (!inside) return 0;
		const sum = u + v + w;
		return (u * p[a] + v * p[b] + w * p[c]) / sum > x ? Math.sign(sum) : 0;
	}

	/** Returns the first and the last column of the grid that a triangle overlaps along an axis. */
	#range(corners: readonly number[], axis: number): [number, number] {
		const columns = corners.map((corner) => this.#column(this.#positions[3 * corner + axis], axis));
		return [Math.min(...columns), Math.max(...columns)];
	}

	/** Returns the column of a coordinate along an axis, 0 … COLUMNS − 1. */
	#column(value: number, axis: number): number {
		const { low, high } = this.box;
		const share = (value - low[axis]) / (high[axis] - low[axis] || 1);
		return Math.max(0, Math.min(COLUMNS - 1, Math.floor(COLUMNS * share)));
	}
}
