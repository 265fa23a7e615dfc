/** The silhouette of a plant, seen from far away along an axis. */
import { type Mesh, Vector3 } from "three";

/** Along the longer edge of a box about the origin that holds all of it; points, not areas, are looked at. */
const PIXELS = 256;

export interface Silhouette {
	readonly dark: Uint8Array;
	readonly low: readonly number[];
	readonly pixel: number;
}

/** @param axis along which one looks: 0 for x, 2 for z */
export function silhouette(meshes: readonly Mesh[], axis: number): Silhouette {
	const triangles = meshes.map((mesh) => placed(mesh, axis));
	const reach =
		1.1 * Math.max(...triangles.flatMap((corners) => corners.reduce((most, v) => Math.max(most, Math.abs(v)), 0)));
	const pixel = (2 * reach) / PIXELS;
	const dark = new Uint8Array(PIXELS * PIXELS);
	for (const corners of triangles)
		for (let at = 0; at < corners.length; at += 6) fill(dark, corners.subarray(at, at + 6), reach, pixel);
	return { dark, low: [-reach, -reach], pixel };
}

/** The share of pixels, of those that are dark in either, which are so in one alone; both at the scale of the first. */
export function unlike(one: Silhouette, other: Silhouette): number {
	let [either, alone] = [0, 0];
	for (let i = 0; i < one.dark.length; i++) {
		const [x, y] = [i % PIXELS, Math.floor(i / PIXELS)].map(
			(at, k) => (one.low[k] + (at + 0.5) * one.pixel - other.low[k]) / other.pixel,
		);
		const [u, v] = [Math.floor(x), Math.floor(y)];
		const there = u >= 0 && v >= 0 && u < PIXELS && v < PIXELS && other.dark[v * PIXELS + u] > 0;
		either += Number(there || one.dark[i] > 0);
		alone += Number(there !== one.dark[i] > 0);
	}
	return alone / either;
}

/** Six numbers a triangle: its corners as one sees them. */
function placed(mesh: Mesh, axis: number): Float64Array {
	const { position } = mesh.geometry.attributes;
	const index = mesh.geometry.index;
	const seen = new Float64Array(2 * (index?.count ?? 0));
	const point = new Vector3();
	for (let i = 0; i < seen.length / 2; i++) {
		point.fromBufferAttribute(position, index?.getX(i) ?? 0).applyMatrix4(mesh.matrixWorld);
		seen.set([axis === 0 ? point.z : point.x, point.y], 2 * i);
	}
	return seen;
}

function fill(dark: Uint8Array, [ax, ay, bx, by, cx, cy]: Float64Array, reach: number, pixel: number): void {
	const from = (...values: number[]) => Math.max(0, Math.floor((Math.min(...values) + reach) / pixel));
	const to = (...values: number[]) => Math.min(PIXELS - 1, Math.floor((Math.max(...values) + reach) / pixel));
	for (let row = from(ay, by, cy); row <= to(ay, by, cy); row++) {
		for (let column = from(ax, bx, cx); column <= to(ax, bx, cx); column++) {
			const [x, y] = [(column + 0.5) * pixel - reach, (row + 0.5) * pixel - reach];
			const sides = [
				(bx - ax) * (y - ay) - (by - ay) * (x - ax),
				(cx - bx) * (y - by) - (cy - by) * (x - bx),
				(ax - cx) * (y - cy) - (ay - cy) * (x - cx),
			];
			if (sides.every((side) => side >= 0) || sides.every((side) => side <= 0)) dark[row * PIXELS + column] = 1;
		}
	}
}
