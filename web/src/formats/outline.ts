/** Outlines of pieces in orthographic views along the axes, and their overlap: a measure of preserved shape. */
import { boundsOf, type Piece } from "./piece";

/** Pixels along the longest edge of the plant's box. */
const PIXELS = 192;
/** The two axes of each picture. */
const VIEWS = [
	[0, 1],
	[1, 2],
	[2, 0],
] as const;

/** One picture per view, 1 where the plant covers the middle of a pixel. */
export type OutlineViews = readonly Uint8Array[];

/**
 * Fixes the scale and position of outlines.
 * @returns a function that draws outlines at the scale and position of these pieces, so that they can be compared
 */
export function outlinesBeside(pieces: readonly Piece[]): (pieces: readonly Piece[]) => OutlineViews {
	const { low, high } = boundsOf(pieces.map(({ mesh }) => mesh.positions));
	const pixel = Math.max(...high.map((value, axis) => value - low[axis])) / PIXELS || 1;
	return (drawn) =>
		VIEWS.map((axes) => {
			const covered = new Uint8Array(PIXELS * PIXELS);
			for (const { mesh } of drawn) cover(covered, mesh, axes, low, pixel);
			return covered;
		});
}

/** Returns the least intersection over union of the covered pixels among the views: 1 where outlines are equal. */
export function agreement(one: OutlineViews, other: OutlineViews): number {
	const shares = one.map((covered, view) => {
		let [both, either] = [0, 0];
		for (const [i, value] of covered.entries()) {
			both += value & other[view][i];
			either += value | other[view][i];
		}
		return either > 0 ? both / either : 1;
	});
	return Math.min(...shares);
}

/**
 * Marks the pixels whose middles a mesh covers in an orthographic view, row by row of each triangle.
 * @param covered PIXELS × PIXELS, 1 where covered
 * @param view indices of the axes that run along rows and columns
 * @param low the corner of the picture, by axis
 * @param pixel edge of a pixel, in units of the mesh
 */
function cover(
	covered: Uint8Array,
	{ positions, indices }: Piece["mesh"],
	[across, up]: (typeof VIEWS)[number],
	low: readonly number[],
	pixel: number,
): void {
	const u = (vertex: number) => (positions[3 * vertex + across] - low[across]) / pixel - 0.5;
	const v = (vertex: number) => (positions[3 * vertex + up] - low[up]) / pixel - 0.5;
	for (let at = 0; at < indices.length; at += 3) {
		const [a, b, c] = [indices[at], indices[at + 1], indices[at + 2]];
		const [au, av, bu, bv, cu, cv] = [u(a), v(a), u(b), v(b), u(c), v(c)];
		const last = Math.min(PIXELS - 1, Math.floor(Math.max(av, bv, cv)));
		for (let row = Math.max(0, Math.ceil(Math.min(av, bv, cv))); row <= last; row++) {
			let [from, to] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
			const addEdge = (pu: number, pv: number, qu: number, qv: number) => {
				if (row < Math.min(pv, qv) || row > Math.max(pv, qv)) return;
				const crossing = pv === qv ? pu : pu + ((row - pv) / (qv - pv)) * (qu - pu);
				from = Math.min(from, crossing);
				to = Math.max(to, crossing);
			};
			addEdge(au, av, bu, bv);
			addEdge(bu, bv, cu, cv);
			addEdge(cu, cv, au, av);
			const [first, end] = [Math.max(0, Math.ceil(from)), Math.min(PIXELS - 1, Math.floor(to))];
			if (end >= first) covered.fill(1, row * PIXELS + first, row * PIXELS + end + 1);
		}
	}
}
