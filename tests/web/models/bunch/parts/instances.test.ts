import { type InstancedMesh, Matrix4, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { alike } from "../../../../../web/src/formats/alike";
import { exportGlb } from "../../../../../web/src/formats/glb";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { bunchParts } from "../../../../../web/src/models/bunch/parts/bunch_parts";
import type { Part } from "../../../../../web/src/plant/part";
import { aboutBunch, specimenFromPreset } from "../../../bunch";
import { freshCore, growBunch } from "../../../core/wasm";
import { load, meshesOf } from "../../../formats/reading";

const specimen = specimenFromPreset("merlot");
const coarse = { stemSides: 5, berrySegments: 8 };
const bunch = async (parameters = {}): Promise<BunchPlant> => {
	const requested = { ...specimen, parameters: { ...specimen.parameters, ...parameters } };
	return growBunch(await freshCore(), requested, coarse);
};
const shared = (grown: BunchPlant) => [...bunchParts(grown, specimen)].map(alike);
const classed = (grown: BunchPlant): Part => shared(grown).find(({ name }) => name === "Berries") as Part;

describe("natural berries that share meshes", () => {
	it("are a few classes in which each berry has its place and size once", async () => {
		const grown = await bunch();
		const { children = [] } = classed(grown);
		expect(children.length).toBeGreaterThan(2);
		expect(children.length).toBeLessThan(12);
		expect(new Set(children.map(({ name }) => name)).size).toBe(children.length);
		const places = children.flatMap(({ shape }) => {
			const { transforms } = shape?.instances ?? { transforms: new Float32Array(0) };
			return Array.from({ length: transforms.length / 8 }, (_, i) => [
				...transforms.slice(8 * i, 8 * i + 3),
				transforms[8 * i + 7],
			]);
		});
		const wanted = Array.from({ length: grown.berries.count }, (_, i) => [
			...grown.berries.spheres.subarray(4 * i, 4 * i + 4),
		]);
		const sorted = (all: number[][]) => all.map((each) => each.join(" ")).sort();
		expect(sorted(places)).toEqual(sorted(wanted));
	});

	it("have a mesh of unit size that faces +Y, its scar there, in one shade", async () => {
		for (const { shape } of classed(await bunch()).children ?? []) {
			const { positions, uvs, sky = [] } = shape?.mesh ?? { positions: [], uvs: [] };
			const at = (vertex: number) => new Vector3().fromArray(positions, 3 * vertex);
			const all = Array.from({ length: uvs.length / 2 }, (_, i) => i);
			for (const vertex of all) expect(Math.abs(at(vertex).length() - 1)).toBeLessThan(0.5);
			const [scar] = all.filter((vertex) => uvs[2 * vertex + 1] === 1);
			expect(at(scar).normalize().y).toBeGreaterThan(0.99);
			expect(new Set(sky).size).toBe(1);
		}
	});

	it("are lighter in classes that see more of the sky", async () => {
		const { children = [] } = classed(await bunch());
		const light = children.map(({ name, shape }) => [/(\d) of 4 in light/.exec(name)?.[1], shape?.mesh.sky?.[0] ?? 0]);
		for (const [step, sky] of light) {
			expect(Number(sky) / 255).toBeGreaterThan((Number(step) - 1) / 4 - 0.01);
			expect(Number(sky) / 255).toBeLessThan(Number(step) / 4 + 0.01);
		}
	});

	it("come back from three.js as instances, about as far out, in a fifth of the nodes", async () => {
		const grown = await bunch();
		const about = await aboutBunch(grown, specimen);
		const glb = exportGlb(shared(grown), about, { instancing: true });
		const instanced = meshesOf((await load(glb)).scene).filter((mesh) => "isInstancedMesh" in mesh) as InstancedMesh[];
		const inOne = meshesOf((await load(glb)).scene).length;
		expect(inOne).toBeLessThan(grown.berries.count / 2);
		const lowest = Math.min(
			...instanced.flatMap((mesh) =>
				Array.from({ length: mesh.count }, (_, i) => {
					const turn = new Matrix4();
					mesh.getMatrixAt(i, turn);
					return new Vector3().applyMatrix4(turn).y;
				}),
			),
		);
		const ys = grown.berries.spheres.filter((_, i) => i % 4 === 1);
		expect(lowest).toBeCloseTo(Math.min(...ys), 4);
	});

	it("bring their open flowers along", async () => {
		const { children = [] } = classed(await bunch({ age: 6 }));
		const flowers = children.find(({ name }) => name === "Flower of all")?.shape?.instances?.transforms.length ?? 0;
		expect(flowers / 8).toBeGreaterThan(50);
	});
});
