/** Meshes normalized to a box, as in the core, and their silhouettes from the front and from above. */

import type { ClosedMesh } from "../../../../specimen/closed_mesh";
import type { Point } from "../../../../ui/handles/point";

/** Caches a function of a mesh. Views call it at each drawing; meshes are immutable. */
export function once<T>(compute: (mesh: ClosedMesh) => T): (mesh: ClosedMesh) => T {
	const cache = new WeakMap<ClosedMesh, { readonly value: T }>();
	return (mesh) => {
		const entry = cache.get(mesh) ?? { value: compute(mesh) };
		cache.set(mesh, entry);
		return entry.value;
	};
}

/** Returns a mesh with its points in shares of its box: x and z in −1 … 1, y in 0 … 1 from below. */
export const inBox = once(({ points, triangles }: ClosedMesh): ClosedMesh => {
	const [low, high] = [
		[Infinity, Infinity, Infinity],
		[-Infinity, -Infinity, -Infinity],
	];
	points.forEach((value, i) => {
		low[i % 3] = Math.min(low[i % 3], value);
		high[i % 3] = Math.max(high[i % 3], value);
	});
	const share = (value: number, k: number) => (high[k] > low[k] ? (value - low[k]) / (high[k] - low[k]) : 0.5);
	return { points: points.map((value, i) => (i % 3 === 1 ? share(value, 1) : 2 * share(value, i % 3) - 1)), triangles };
});

const CONTOURS = { 1: once((mesh) => contour(mesh, 1)), 2: once((mesh) => contour(mesh, 2)) } as const;

/**
 * Returns the silhouette of a mesh as loops along the edges between front and back faces, with holes and folds.
 * @param up the axis that points up in the picture: 1 from the front, 2 from above with the front below
 */
export const contourOf = (mesh: ClosedMesh, up: 1 | 2): readonly (readonly Point[])[] => CONTOURS[up](mesh);

/**
 * Returns the silhouette of a mesh normalised to its box, as closed loops.
 * @param up the axis that is up in the view: 1 (y) from the front, 2 (−z) from above
 */
function contour(mesh: ClosedMesh, up: 1 | 2): Point[][] {
	const { points, triangles } = inBox(mesh);
	const pointAt = (corner: number): Point => ({
		x: points[3 * corner],
		y: (up === 2 ? -1 : 1) * points[3 * corner + up],
	});
	/** Edges of triangles that face the viewer, by both ends; an edge of two such triangles cancels. */
	const edges = new Map<string, readonly [number, number]>();
	for (let i = 0; i < triangles.length; i += 3) {
		const corners = triangles.slice(i, i + 3);
		const [a, b, c] = corners.map(pointAt);
		if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) <= 0) continue;
		corners.forEach((from, k) => {
			const to = corners[(k + 1) % 3];
			if (!edges.delete(`${to} ${from}`)) edges.set(`${from} ${to}`, [from, to]);
		});
	}
	return loopsOf([...edges.values()]).map((loop) => loop.map(pointAt));
}

/** Joins directed edges, pairs of corners, to closed loops of corners. */
function loopsOf(edges: readonly (readonly [number, number])[]): number[][] {
	const nextCorners = new Map<number, number[]>();
	for (const [from, to] of edges) nextCorners.set(from, [...(nextCorners.get(from) ?? []), to]);
	const loops: number[][] = [];
	for (const [from] of edges) {
		const loop: number[] = [];
		for (let corner: number | undefined = from; corner !== undefined; corner = nextCorners.get(corner)?.pop())
			loop.push(corner);
		if (loop.at(-1) === loop[0]) loop.pop();
		if (loop.length > 2) loops.push(loop);
	}
	return loops;
}
