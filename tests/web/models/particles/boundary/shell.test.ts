import { describe, expect, it } from "vitest";
import { contourOf } from "../../../../../web/src/models/particles/boundary/editor/mesh_outline";
import { shellsOf } from "../../../../../web/src/models/particles/boundary/editor/shell";
import { treeLayout } from "../../../../../web/src/models/tree/layout";
import { TREE } from "../../../../../web/src/models/tree/schema";
import { tree } from "./particles";

describe("a dropped mesh", () => {
	/** An L-shaped prism, one unit thick, its base to the left. */
	const L = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]]; // biome-ignore format: corners
	const mesh = {
		points: [0, 1].flatMap((z) => L.flatMap(([x, y]) => [x, y, z])),
		triangles: [
			...[0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5].map((i) => 6 + i),
			...[0, 2, 1, 0, 3, 2, 0, 4, 3, 0, 5, 4],
			...L.flatMap((_, i) => [i, (i + 1) % 6, 6 + ((i + 1) % 6), i, 6 + ((i + 1) % 6), 6 + i]),
		],
	};

	it("is seen as its silhouette, not as a likeness of both sides", () => {
		const [loop, ...more] = contourOf(mesh, 1);
		expect(more).toEqual([]);
		expect(loop).toHaveLength(6);
		expect(loop).toContainEqual({ x: expect.closeTo(-1 / 3), y: expect.closeTo(1 / 3) });
		expect(loop).toContainEqual({ x: 1, y: 0 });
		expect(loop).not.toContainEqual({ x: 1, y: 1 });
	});

	it("is a rectangle from above, its front below", () => {
		// Its two top faces have different heights, so each has its own edge.
		const loops = contourOf(mesh, 2);
		expect(loops).toHaveLength(2);
		const xs = loops.flat().map(({ x }) => x);
		const ys = loops.flat().map(({ y }) => y);
		expect([Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)]).toEqual([-1, 1, -1, 1]);
	});

	it("keeps its hole", () => {
		// A frame: the square from 0 to 3 without that from 1 to 2.
		const outer = [[0, 0], [3, 0], [3, 3], [0, 3]]; // biome-ignore format: corners
		const inner = [[1, 1], [2, 1], [2, 2], [1, 2]]; // biome-ignore format: corners
		const points = [0, 1].flatMap((z) => [...outer, ...inner].flatMap(([x, y]) => [x, y, z]));
		const ring = [0, 1, 2, 3].flatMap((i) => {
			const [a, b, c, d] = [i, (i + 1) % 4, 4 + ((i + 1) % 4), 4 + i];
			return [a, b, c, a, c, d];
		});
		const front = ring.map((i) => i + 8);
		const back = ring.map((_, i) => ring[i % 3 === 0 ? i : i % 3 === 1 ? i + 1 : i - 1]);
		expect(contourOf({ points, triangles: [...front, ...back] }, 1)).toHaveLength(2);
	});
});

describe("a boundary in 3-D", () => {
	const extent = (points: readonly number[], k: number) => {
		const along = points.filter((_, i) => i % 3 === k);
		return [Math.min(...along), Math.max(...along)];
	};

	it.each(["sphere", "box", "cypress", "twin"])("fills the box that the core grows in: %s", (preset) => {
		const specimen = tree(preset);
		const { halfWidth, low, high } = treeLayout.box(specimen);
		const shells = shellsOf(treeLayout, specimen);
		expect(shells).toHaveLength(specimen.parameters.crowns);
		const deep = treeLayout.halfDepth(specimen);
		for (const [i, axis] of treeLayout.axes(specimen).entries()) {
			const { points, triangles } = shells[i];
			const near = [0, 1, 2].map((k) => extent(points, k).map((value) => Math.round(10 * value) / 10));
			const box = [
				[axis - halfWidth, axis + halfWidth],
				[low, high],
				[-deep, deep],
			];
			box.forEach((range, k) => {
				expect(Math.abs(near[k][0] - range[0])).toBeLessThan(0.08);
				expect(Math.abs(near[k][1] - range[1])).toBeLessThan(0.08);
			});
			expect(Math.max(...triangles)).toBe(points.length / 3 - 1);
		}
	});

	it("has within it the mesh of an inner boundary, in the box made smaller", () => {
		const box = tree("box");
		const hollow = { points: [5, 0, 5, 7, 0, 5, 5, 0, 9, 5, 3, 5], triangles: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2] };
		const specimen = { ...box, hollow, parameters: { ...box.parameters, inner: 0.5 } };
		const { width, depth, trunk, height } = specimen.parameters;
		const [, inner, ...more] = shellsOf(treeLayout, specimen);
		expect(more).toEqual([]);
		const expected = [
			[-width / 4, width / 4],
			[trunk + height / 4, trunk + 0.75 * height],
			[-depth / 4, depth / 4],
		];
		expected.forEach((range, k) => {
			for (const [i, end] of extent(inner.points, k).entries()) expect(end).toBeCloseTo(range[i], 6);
		});
		expect(shellsOf(treeLayout, { ...specimen, parameters: { ...specimen.parameters, inner: 0 } })).toHaveLength(1);
	});

	it("is a mesh's own, stretched to the box", () => {
		const box = tree("box");
		const shape = TREE.table.entry("shape");
		const volume = { points: [5, 0, 5, 7, 0, 5, 5, 0, 9, 5, 3, 5], triangles: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2] };
		const mesh = shape?.kind === "choice" ? shape.options.indexOf("mesh") : -1;
		const specimen = { ...box, volume, parameters: { ...box.parameters, shape: mesh } };
		const { width, depth, trunk, height } = specimen.parameters;
		const [{ points }] = shellsOf(treeLayout, specimen);
		expect([0, 1, 2].map((k) => extent(points, k))).toEqual([
			[-width / 2, width / 2],
			[trunk, trunk + height],
			[-depth / 2, depth / 2],
		]);
	});
});
