import { readFile } from "node:fs/promises";
import { gzipSync } from "node:zlib";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../web/src/core/loader";
import { GROWTH_TABLE } from "../../../../web/src/models/growth/table";
import { BAKED_LEAVES, bakedSpecimen, bakeLeaf } from "../../../../web/src/models/leaf/attached/bake";
import { readLeaf as readGrownLeaf } from "../../../../web/src/models/leaf/read_leaf";
import { encodeLeaf } from "../../../../web/src/models/leaf/request";
import { TREE_TABLE } from "../../../../web/src/models/tree/table";
import { type LeafFile, readLeaf } from "../../../../web/src/plant/leaf";

const text = (preset: string) => readFile(`web/src/plant/leaves/${preset}.json`, "utf8");
const committed = async (preset: string): Promise<LeafFile> => JSON.parse(await text(preset));

/** Whether two arrays are equal: faster than computing a difference. */
const same = (a: ArrayBufferView = new Uint8Array(), b: ArrayBufferView = new Uint8Array()) =>
	Buffer.from(a.buffer, a.byteOffset, a.byteLength).equals(Buffer.from(b.buffer, b.byteOffset, b.byteLength));

let core: Core;
beforeAll(async () => {
	core = await loadCoreFromBytes(await readFile("build/core/particles.wasm"));
});

describe.each(BAKED_LEAVES)("the leaf of %s for attachment", (preset) => {
	it("matches the preset's growth and the script's output", async () => {
		const [file, anew] = [await committed(preset), bakeLeaf(core, preset)];
		expect(file.from).toBe(anew.from);
		const [one, other] = [await readLeaf(file), await readLeaf(anew)];
		const changed = "the leaf model has changed: run `npm run generate -- leaves`, look at the leaf, and commit it";
		for (const key of ["points", "between", "uvs", "indices"] as const)
			expect(same(one[key], other[key]), `${key}: ${changed}`).toBe(true);
		expect(one.veins?.side).toBe(other.veins?.side);
		expect(same(one.veins?.shares, other.veins?.shares), `veins: ${changed}`).toBe(true);
	});

	it("lies flat about its petiole, its tip up, each triangle counter-clockwise, in its picture as on the blade", async () => {
		const { points, between, uvs, indices } = await readLeaf(await committed(preset));
		const count = points.length / 2;
		expect([between.length, uvs.length]).toEqual([count, 2 * count]);
		expect(Math.hypot(points[0], points[1])).toBeLessThan(0.002);
		const heights = points.filter((_, at) => at % 2 === 1);
		expect(Math.max(...heights)).toBeCloseTo(1, 1);
		const area = (values: Float32Array, at: number) => {
			const [a, b, c] = indices.subarray(at, at + 3);
			const side = (to: number, k: number) => values[2 * to + k] - values[2 * a + k];
			return side(b, 0) * side(c, 1) - side(b, 1) * side(c, 0);
		};
		for (let at = 0; at < indices.length; at += 3) {
			expect(Math.max(...indices.subarray(at, at + 3))).toBeLessThan(count);
			expect(area(points, at)).toBeGreaterThanOrEqual(0);
			// v runs down.
			expect(area(uvs, at)).toBeLessThanOrEqual(0);
		}
		for (const values of [between, uvs]) {
			expect(Math.min(...values)).toBeGreaterThanOrEqual(0);
			expect(Math.max(...values)).toBeLessThanOrEqual(1);
		}
	});
});

describe("the sketch of the leaf on a cane", () => {
	it("is small, and as long and wide as the leaf, so that the view of both is one", async () => {
		// The sketch comes with the first load, the detailed leaf later.
		const [small, large] = await Promise.all(["grapevine_sketch", "grapevine"].map(text));
		expect(gzipSync(small).length).toBeLessThan(gzipSync(large).length / 10);
		const [sketch, leaf] = await Promise.all(
			["grapevine_sketch", "grapevine"].map(async (name) => (await readLeaf(await committed(name))).points),
		);
		const ends = (points: Float32Array, axis: number) => {
			const along = points.filter((_, at) => at % 2 === axis);
			return [Math.min(...along), Math.max(...along)];
		};
		for (const axis of [0, 1]) {
			for (const [at, end] of ends(sketch, axis).entries()) {
				expect(Math.abs(end - ends(leaf, axis)[at])).toBeLessThan(0.06);
			}
		}
	});
});

const onTrees = BAKED_LEAVES.filter((name) => !name.startsWith("grapevine"));

describe("the leaves of trees", () => {
	it("are those of every kind that a tree can have, but needles", () => {
		const kindsOf = (table: typeof TREE_TABLE | typeof GROWTH_TABLE) => {
			const kinds = table.entry("leaf_kind");
			return kinds?.kind === "choice" ? kinds.options : [];
		};
		const grown = kindsOf(GROWTH_TABLE);
		expect(grown.filter((kind) => !["none", "needle", "spray"].includes(kind)).toSorted()).toEqual(onTrees.toSorted());
		expect(kindsOf(TREE_TABLE).filter((kind) => !grown.includes(kind))).toEqual([]);
	});

	it.each(onTrees)(
		"are few triangles of %s's own outline, in two halves that fold along the midrib",
		async (preset) => {
			const { points, indices, petiole, veins } = await readLeaf(await committed(preset));
			const { parameters } = bakedSpecimen(preset);
			expect(indices.length / 3).toBeLessThan(26);
			expect(veins?.side).toBe(64);
			expect(petiole?.[0]).toBeCloseTo(parameters.petiole / 100, 5);
			expect(petiole?.[1]).toBeCloseTo(parameters.petiole_width / parameters.length, 5);
			// No triangle lies on both sides of the midrib, and each half has its own places on it.
			const side = (vertex: number) => Math.sign(Math.round(1000 * points[2 * vertex]));
			const sides = Array.from({ length: indices.length / 3 }, (_, at) => {
				const found = new Set([...indices.subarray(3 * at, 3 * at + 3)].map(side).filter((each) => each !== 0));
				expect(found.size).toBe(1);
				return [...found][0];
			});
			const used = (which: number) =>
				new Set(sides.flatMap((each, at) => (each === which ? [...indices.subarray(3 * at, 3 * at + 3)] : [])));
			const [right, left] = [used(1), used(-1)];
			expect([...right].filter((vertex) => left.has(vertex))).toEqual([]);
			expect(right.size + left.size).toBe(points.length / 2);
			// The area is about that of the leaf.
			const { margin } = readGrownLeaf(core.grow(encodeLeaf(bakedSpecimen(preset), { meshes: false })));
			let own = 0;
			for (let i = 0, j = margin.length - 2; i < margin.length; j = i, i += 2) {
				own += (margin[j] * margin[i + 1] - margin[i] * margin[j + 1]) / 2;
			}
			let area = 0;
			for (let at = 0; at < indices.length; at += 3) {
				const [a, b, c] = [...indices.subarray(at, at + 3)].map((k) => [points[2 * k], points[2 * k + 1]]);
				area += ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
			}
			expect(area / own).toBeGreaterThan(0.85);
			expect(area / own).toBeLessThan(1.15);
		},
	);
});

describe("the grapevine's leaf", () => {
	it("is light, has its five main veins in its picture, and is highest between them", async () => {
		const { points, between, uvs, indices, veins } = await readLeaf(await committed("grapevine"));
		expect(indices.length / 3).toBeLessThan(800);
		if (!veins) throw new Error("no veins");
		const { side, shares } = veins;
		expect(shares).toHaveLength(side * side);
		const shown = (vertex: number) =>
			shares[Math.min(side - 1, Math.floor(uvs[2 * vertex + 1] * side)) * side + Math.floor(uvs[2 * vertex] * side)];
		expect(shown(0)).toBe(255);
		// A circle around the petiole: bright pixels are main veins or their branches.
		const [px, py] = [uvs[0] * side, uvs[1] * side];
		const scale = (side * (uvs[2] - uvs[0])) / (points[2] - points[0]);
		const round = Array.from({ length: 720 }, (_, k) => {
			const [x, y] = [Math.sin((k * Math.PI) / 360), -Math.cos((k * Math.PI) / 360)];
			return shares[Math.round(py + scale * 0.2 * y) * side + Math.round(px + scale * 0.2 * x)] > 200;
		});
		expect(round[0]).toBe(true);
		const begun = round.filter((bright, k) => bright && !round.at(k - 1));
		expect(begun.length).toBeGreaterThanOrEqual(5);
		expect(begun.length).toBeLessThan(10);
		expect(between[0]).toBe(0);
		expect(between.filter((value) => value > 0.8).length).toBeGreaterThan(20);
	});
});

it("a leaf that was damaged on its way is not read", async () => {
	const file = await committed("grapevine");
	await expect(readLeaf({ ...file, data: file.data.slice(0, 4000) })).rejects.toThrow();
	await expect(readLeaf({ ...file, data: "?" })).rejects.toThrow();
});
