import type { BufferGeometry, LineSegments, Mesh } from "three";
import { describe, expect, it } from "vitest";
import { ShellRenderer } from "../../../web/src/render/shell_renderer";

/** A unit cube's corners and faces. */
const corners = [0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].flatMap((z) => [x, y, z])));
const faces = [
	[0, 1, 3, 2],
	[4, 6, 7, 5],
	[0, 4, 5, 1],
	[2, 3, 7, 6],
	[0, 2, 6, 4],
	[1, 5, 7, 3],
].flatMap(([a, b, c, d]) => [a, b, c, a, c, d]);

const edgesIn = (renderer: ShellRenderer, shell = 0): BufferGeometry =>
	(renderer.object.children.filter((part) => "isLineSegments" in part)[shell] as LineSegments).geometry;

/** Both ends of each edge, sorted. */
function ends({ attributes: { position }, index }: BufferGeometry): string[] {
	const at = (i: number) => [position.getX(i), position.getY(i), position.getZ(i)].join();
	const points = [...(index?.array ?? [])];
	return points.flatMap((a, i) => (i % 2 === 0 ? [[at(a), at(points[i + 1])].sort().join(" – ")] : [])).sort();
}

describe("the renderer of bounding shells", () => {
	it("draws faces, and edges between faces that are not coplanar", () => {
		const renderer = new ShellRenderer();
		renderer.show([{ points: corners, triangles: faces }], "red");
		expect((renderer.object.children[0] as Mesh).geometry.index?.count).toBe(36);
		const found = ends(edgesIn(renderer));
		expect(found).toHaveLength(12);
		expect(found).toContain("0,0,0 – 0,0,1");
		expect(found).not.toContain("0,0,0 – 0,1,1");
	});

	it("finds edges once: a moved body reuses its edges at its new place", () => {
		const renderer = new ShellRenderer();
		renderer.show([{ points: corners, triangles: faces }], "red");
		const first = [...(edgesIn(renderer).index?.array ?? [])];
		// Edges of these triangles come from the cache, so the new positions do not change them.
		const flat = corners.map((value, i) => (i % 3 === 1 ? 0 : value));
		renderer.show([{ points: corners.map((value) => value + 2), triangles: faces }], "red");
		expect(ends(edgesIn(renderer))).toContain("2,2,2 – 2,2,3");
		renderer.show([{ points: flat, triangles: faces }], "red");
		expect([...(edgesIn(renderer).index?.array ?? [])]).toEqual(first);
		renderer.show([{ points: flat, triangles: [...faces] }], "red");
		expect([...(edgesIn(renderer).index?.array ?? [])]).not.toEqual(first);
	});
});
