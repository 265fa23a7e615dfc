/** Surface meshes of areas, for the view. */
import type { ClosedMesh } from "../../../specimen/closed_mesh";
import { type Area, type AreaKind, placeIn, type Triple } from "./area";

const SIDES = 32;

/** Returns the surface of an area in metres, rotated and placed. */
export function surfaceOf(area: Area): ClosedMesh {
	const { points, triangles } = area.kind === "mesh" ? stretched(area.mesh) : formOf(area.kind);
	const placed: number[] = [];
	for (let i = 0; i < points.length; i += 3) placed.push(...placeIn(area, [points[i], points[i + 1], points[i + 2]]));
	return { points: placed, triangles };
}

const forms = new Map<AreaKind, ClosedMesh>();

/** Returns the surface of a kind of area, within −1 … 1 on each axis. */
function formOf(kind: AreaKind): ClosedMesh {
	const known = forms.get(kind) ?? meshOfKind(kind);
	forms.set(kind, known);
	return known;
}

/** Returns the closed mesh of an area's kind, from −1 to 1 along each axis. */
function meshOfKind(kind: AreaKind): ClosedMesh {
	if (kind === "box") return box();
	if (kind === "cylinder")
		return revolved([
			[0, -1],
			[1, -1],
			[1, 1],
			[0, 1],
		]);
	if (kind === "cone")
		return revolved([
			[0, -1],
			[1, -1],
			[0, 1],
		]);
	const rings = SIDES / 2;
	const ring = (i: number): [number, number] => [Math.sin((i * Math.PI) / rings), -Math.cos((i * Math.PI) / rings)];
	return revolved(Array.from({ length: rings + 1 }, (_, i) => ring(i)));
}

/** Returns a cube from −1 to 1: corners in the order of their x, y and z, and two triangles per face. */
function box(): ClosedMesh {
	const sides: Triple = [-1, 1, 0];
	const points = [0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].flatMap((z) => [sides[x], sides[y], sides[z]])));
	const faces = [
		[0, 1, 3, 2],
		[4, 6, 7, 5],
		[0, 4, 5, 1],
		[2, 3, 7, 6],
		[0, 2, 6, 4],
		[1, 5, 7, 3],
	];
	return { points, triangles: faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]) };
}

/** Returns the surface of revolution of a line of (radius, height) about the vertical axis. */
function revolved(line: readonly (readonly [number, number])[]): ClosedMesh {
	const points = line.flatMap(([radius, height]) =>
		Array.from({ length: SIDES }, (_, i) => (2 * Math.PI * i) / SIDES).flatMap((angle) => [
			radius * Math.cos(angle),
			height,
			radius * Math.sin(angle),
		]),
	);
	const triangles: number[] = [];
	for (let ring = 0; ring + 1 < line.length; ring++)
		for (let i = 0; i < SIDES; i++) {
			const [a, b] = [ring * SIDES + i, ring * SIDES + ((i + 1) % SIDES)];
			if (line[ring][0] > 0) triangles.push(a, b + SIDES, b);
			if (line[ring + 1][0] > 0) triangles.push(a, a + SIDES, b + SIDES);
		}
	return { points, triangles };
}

/** Scales a mesh into a box of −1 … 1 on each axis; empty if there is none. */
function stretched(mesh: ClosedMesh = { points: [], triangles: [] }): ClosedMesh {
	const [low, high] = [Math.min, Math.max].map((extreme) =>
		[0, 1, 2].map((k) =>
			mesh.points.reduce((most, value, i) => (i % 3 === k ? extreme(most, value) : most), mesh.points[k]),
		),
	);
	const place = (value: number, k: number) => (high[k] > low[k] ? (2 * (value - low[k])) / (high[k] - low[k]) - 1 : 0);
	return { points: mesh.points.map((value, i) => place(value, i % 3)), triangles: mesh.triangles };
}
