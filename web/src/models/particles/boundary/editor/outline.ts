/**
 * Outlines of boundaries from the front, in shares of the box: radius from the axis, height from the lowest point
 * (wasm-core/src/models/particles/boundary.cpp).
 */
import type { ClosedMesh } from "../../../../specimen/closed_mesh";
import type { Knot } from "../bounded";
import { inBox, once } from "./mesh_outline";

export type Form = "ellipsoid" | "box" | "cone" | "coneDown" | "bowl" | "spline" | "mesh";

/** Pieces of a spline between two knots, as in the core. */
const PIECES = 6;
/** Segments of a circular arc. */
const ARC = 48;
/** Number of height steps of a mesh's silhouette. */
const LEVELS = 40;

/** Returns the right half of an outline, from below; of an asymmetric mesh the wider half. */
export function outlineOf(form: Form, profile: readonly Knot[], mesh?: ClosedMesh): readonly Knot[] {
	switch (form) {
		case "box":
			return [[0, 0], [1, 0], [1, 1], [0, 1]]; // biome-ignore format: a square
		case "cone":
			return [[0, 0], [1, 0], [0, 1]]; // biome-ignore format: a triangle
		case "coneDown":
			return [[0, 0], [1, 1], [0, 1]]; // biome-ignore format: a triangle
		case "bowl":
			return [...arc(0, Math.PI / 2).map(([radius, sine]): Knot => [radius, sine + 1]), [0, 1]];
		case "spline":
			return [[0, profile[0][1]], ...splineThrough(profile), [0, profile[profile.length - 1][1]]];
		case "mesh":
			return mesh && mesh.points.length > 0 ? silhouette(mesh) : outlineOf("ellipsoid", profile);
		case "ellipsoid":
			return arc(-Math.PI / 2, Math.PI / 2).map(([radius, sine]) => [radius, 0.5 + 0.5 * sine]);
	}
}

/**
 * Returns points of a circular arc, as cosine and sine, in `ARC` steps between two angles in radians. An arc from 0 is
 * the quarter below instead: from −π/2 to 0.
 */
function arc(from: number, to: number): Knot[] {
	const range = from === 0 ? [-Math.PI / 2, 0] : [from, to];
	return Array.from({ length: ARC + 1 }, (_, i) => {
		const angle = range[0] + ((range[1] - range[0]) * i) / ARC;
		return [Math.cos(angle), Math.sin(angle)];
	});
}

/** Returns points of the Catmull–Rom spline through points; radii are not negative. */
export function splineThrough(points: readonly Knot[]): Knot[] {
	const line: Knot[] = [];
	const last = points.length - 1;
	for (let i = 0; i < last; i++) {
		const [a, b, c, d] = [-1, 0, 1, 2].map((by) => points[Math.min(Math.max(i + by, 0), last)]);
		for (let k = 0; k < PIECES; k++) {
			const t = k / PIECES;
			const [radius, height] = [0, 1].map(
				(j) =>
					0.5 *
					(2 * b[j] +
						t * (c[j] - a[j] + t * (2 * a[j] - 5 * b[j] + 4 * c[j] - d[j] + t * (3 * (b[j] - c[j]) + d[j] - a[j])))),
			);
			line.push([Math.max(0, radius), height]);
		}
	}
	return [...line, points[last]];
}

/** Returns the largest half width of a mesh at `LEVELS` heights, from the intersections of its edges. */
const silhouette = once((mesh: ClosedMesh): readonly Knot[] => {
	const { points, triangles } = inBox(mesh);
	const widths = new Float32Array(LEVELS + 1);
	for (let i = 0; i < triangles.length; i++) {
		const [from, to] = [triangles[i], triangles[i % 3 === 2 ? i - 2 : i + 1]].map((corner) => [
			points[3 * corner],
			points[3 * corner + 1] * LEVELS,
		]);
		const [low, high] = from[1] <= to[1] ? [from, to] : [to, from];
		for (let level = Math.floor(low[1]); level <= Math.ceil(high[1]) && level <= LEVELS; level++) {
			const t = high[1] > low[1] ? Math.min(1, Math.max(0, (level - low[1]) / (high[1] - low[1]))) : 0;
			widths[level] = Math.max(widths[level], Math.abs(low[0] + t * (high[0] - low[0])));
		}
	}
	return [[0, 0], ...Array.from(widths, (width, level): Knot => [width, level / LEVELS]), [0, 1]];
});

/** Returns the largest radius of an outline at a height. */
export function radiusAt(outline: readonly Knot[], height: number): number {
	let widest = 0;
	for (let i = 0; i + 1 < outline.length; i++) {
		const [a, b] = [outline[i], outline[i + 1]];
		if (Math.min(a[1], b[1]) > height || Math.max(a[1], b[1]) < height) continue;
		const t = a[1] === b[1] ? 0 : (height - a[1]) / (b[1] - a[1]);
		widest = Math.max(widest, a[1] === b[1] ? Math.max(a[0], b[0]) : a[0] + t * (b[0] - a[0]));
	}
	return widest;
}
