import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import { loadCoreFromBytes } from "../../../../web/src/core/loader";
import { bakedGlb } from "../../../../web/src/models/leaf/bake/baked_glb";
import { bakedParts } from "../../../../web/src/models/leaf/bake/baked_parts";
import { lightMesh } from "../../../../web/src/models/leaf/bake/light_mesh";
import type { Leaf } from "../../../../web/src/models/leaf/grown";
import { model } from "../../../../web/src/models/leaf/index";
import { leafFromPreset } from "../../../../web/src/models/leaf/schema";
import type { Picture } from "../../../../web/src/plant/material";
import type { PartMesh, Shape } from "../../../../web/src/plant/part";
import type { PlantMesh } from "../../../../web/src/plant/plant";
import { complaints, documentOf } from "../../formats/reading";

const specimen = leafFromPreset("grapevine");
let leaf: Leaf;
let upper: PlantMesh;
let grow: (from: typeof specimen) => Leaf;
beforeAll(async () => {
	const core = await loadCoreFromBytes(await readFile("build/core/particles.wasm"));
	grow = (from) => model.read(core.grow(model.encode(from)));
	leaf = grow(specimen);
	upper = leaf.meshes.find(({ name }) => name === "upper") as PlantMesh;
});

/** Areas of the triangles in the chart. */
function areas({ uvs, indices }: Pick<PlantMesh, "uvs" | "indices">): number[] {
	return Array.from({ length: indices.length / 3 }, (_, triangle) => {
		const [a, b, c] = indices.subarray(3 * triangle, 3 * triangle + 3);
		const [ux, uy] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]];
		const [vx, vy] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]];
		return (ux * vy - uy * vx) / 2;
	});
}

describe("the light mesh", () => {
	it("has a fifth of the triangles, covers the same, and nothing of it is turned over", () => {
		const light = lightMesh(upper, leaf.faces.upper.edge, 24);
		expect(light.indices.length).toBeLessThan(upper.indices.length / 4);
		const [one, other] = [areas(light), areas(upper)].map((each) => each.reduce((sum, area) => sum + area, 0));
		expect(one / other).toBeCloseTo(1, 3);
		expect(Math.min(...areas(light))).toBeGreaterThanOrEqual(0);
	});

	it("is shaded as the blade, not as the veins that happen to lie under its vertices", () => {
		const flat = { ...specimen, parameters: { ...specimen.parameters, curl: 0, fold: 0, undulation: 0, relief: 2 } };
		const grown = grow(flat);
		const mesh = grown.meshes.find(({ name }) => name === "upper") as PlantMesh;
		const upright = (normals: Float32Array) => Math.min(...normals.filter((_, at) => at % 3 === 2).map(Math.abs));
		expect(upright(trueNormals(mesh))).toBeLessThan(0.9);
		expect(upright(lightMesh(mesh, grown.faces.upper.edge, 24).normals)).toBeGreaterThan(0.97);
	});
});

type Vector = [x: number, y: number, z: number];
const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (a: Vector, by: number): Vector => [a[0] * by, a[1] * by, a[2] * by];
const cross = (a: Vector, b: Vector): Vector => [
	a[1] * b[2] - a[2] * b[1],
	a[2] * b[0] - a[0] * b[2],
	a[0] * b[1] - a[1] * b[0],
];
const unit = (a: Vector): Vector => times(a, 1 / Math.hypot(...a));
const vector = (values: Float32Array, at: number) => [...values.subarray(3 * at, 3 * at + 3)] as Vector;

/**
 * By triangle, the direction of increasing u as glTF readers compute it from the corners (MikkTSpace, equal to three's
 * derivatives), and whether u × v agrees with the normal.
 */
function frameOf({ positions, uvs }: PartMesh, [a, b, c]: Uint32Array) {
	const [p, q] = [minus(vector(positions, b), vector(positions, a)), minus(vector(positions, c), vector(positions, a))];
	const [du1, dv1] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]];
	const [du2, dv2] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]];
	const turn = du1 * dv2 - du2 * dv1;
	return { tangent: times(minus(times(p, dv2), times(q, dv1)), 1 / turn), turn };
}

/** By vertex, the area-weighted normal of the adjacent triangles. */
function trueNormals({ positions, indices }: Pick<PlantMesh, "positions" | "indices">): Float32Array {
	const normals = new Float32Array(positions.length);
	for (let at = 0; at < indices.length; at += 3) {
		const corners = indices.subarray(at, at + 3);
		const [a, b, c] = [...corners].map((corner) => vector(positions, corner));
		const twice = cross(minus(b, a), minus(c, a));
		for (const corner of corners) for (let k = 0; k < 3; k++) normals[3 * corner + k] += twice[k];
	}
	for (let at = 0; at < normals.length; at += 3) normals.set(unit([...normals.subarray(at, at + 3)] as Vector), at);
	return normals;
}

function sampled({ width, height, pixels }: Picture, u: number, v: number): Vector {
	const at = 3 * (Math.floor(v * height) * width + Math.floor(u * width));
	return [0, 1, 2].map((k) => pixels[at + k] / 127.5 - 1) as Vector;
}

describe.each(["upper", "lower"] as const)("normals baked for the %s face", (side) => {
	/** A leaf with a flat blade and veins in relief: dense, so that the mesh shows them accurately. */
	function compared() {
		const bold = { thickness: 2.5, vein: 8, relief: 1, curl: 25, fold: 12, undulation: 0, particles: 60, length: 110 };
		const from = { ...specimen, parameters: { ...specimen.parameters, ...bold } };
		const grown = grow(from);
		const mesh = grown.meshes.find(({ name }) => name === side) as PlantMesh;
		const index = side === "upper" ? 0 : 1;
		const { mesh: light, material } = [...bakedParts(grown, from, { pixels: 512 })][index].shape as Shape;
		return { mesh, light, normal: material.textures?.normal as Picture, edge: grown.faces[side].edge };
	}

	it("lean as the dense mesh's do, red to +u and green to −v, in every direction", () => {
		const { mesh, light, normal, edge } = compared();
		const seen = mesh.uvs.map((value, at) => (at % 2 === 0 && side === "upper" ? value : 1 - value));
		const [alongU, alongV] = [0, 0].map(() => ({ same: 0, mine: 0, its: 0, count: 0 }));
		const normals = trueNormals(mesh);
		const triangles = areas(light).map((_, at) => light.indices.subarray(3 * at, 3 * at + 3));
		for (let vertex = 0; vertex < edge.length; vertex++) {
			if (edge[vertex] < 0.03) continue;
			const [u, v] = seen.subarray(2 * vertex, 2 * vertex + 2);
			const under = triangles.find((corners) => holds(light.uvs, corners, u, v));
			if (!under) continue;
			const { tangent, turn } = frameOf(light, under);
			const blade = unit(
				cross(
					minus(vector(light.positions, under[1]), vector(light.positions, under[0])),
					minus(vector(light.positions, under[2]), vector(light.positions, under[0])),
				),
			);
			// Not mirrored: v runs down where u runs right.
			expect(turn).toBeLessThan(0);
			const t = unit(minus(tangent, times(blade, dot(tangent, blade))));
			const up = cross(blade, t);
			const [x, y] = sampled(normal, u, v);
			const its = vector(normals, vertex);
			for (const [sum, mine, true_] of [
				[alongU, x, dot(its, t)],
				[alongV, y, dot(its, up)],
			] as const) {
				sum.same += mine * true_;
				sum.mine += mine * mine;
				sum.its += true_ * true_;
				if (Math.abs(mine) > 0.1) sum.count++;
			}
		}
		for (const { same, mine, its, count } of [alongU, alongV]) {
			expect(count).toBeGreaterThan(50);
			expect(same / Math.sqrt(mine * its)).toBeGreaterThan(0.5);
		}
	});
});

function holds(uvs: Float32Array, [a, b, c]: Uint32Array, u: number, v: number): boolean {
	const side = (i: number, j: number) =>
		(uvs[2 * j] - uvs[2 * i]) * (v - uvs[2 * i + 1]) - (uvs[2 * j + 1] - uvs[2 * i + 1]) * (u - uvs[2 * i]);
	const sides = [side(a, b), side(b, c), side(c, a)];
	return sides.every((each) => each <= 0) || sides.every((each) => each >= 0);
}

it("a baked leaf is a valid glTF (Khronos validator) with three textures per face", async () => {
	const glb = await bakedGlb(leaf, specimen, "?model=leaf", { pixels: 128 });
	const found = await complaints(glb);
	expect(found).toEqual([]);
	const { materials = [] } = documentOf(glb) as { materials?: { name: string }[] };
	expect(materials.map(({ name }) => name)).toEqual(["Blade, upper face", "Blade, lower face", "Petiole"]);
	expect((documentOf(glb) as unknown as { textures: unknown[] }).textures).toHaveLength(6);
});
