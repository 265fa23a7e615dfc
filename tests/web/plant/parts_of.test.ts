import { describe, expect, it } from "vitest";
import { type Material, standardMaterial } from "../../../web/src/plant/material";
import { everyPart } from "../../../web/src/plant/part";
import { partsOf } from "../../../web/src/plant/parts_of";
import { toyPlant } from "./toy_plant";

const plant = toyPlant();

describe("partsOf", () => {
	it("gives a part to each run that has triangles, to each whole mesh and to what organs are drawn with", () => {
		expect([...partsOf(plant)].map(({ name }) => name)).toEqual(["Trunk", "Branch", "Bract", "Leaf"]);
	});

	it("cuts runs out, indices counted from their own first vertex", () => {
		const [trunk, branch] = [...partsOf(plant)].map(({ shape }) => shape?.mesh);
		expect(branch?.positions).toEqual(plant.meshes[0].positions.subarray(24));
		expect(branch?.indices).toEqual(trunk?.indices);
		expect(Math.max(...(branch?.indices ?? []))).toBe(7);
		// A plant may have millions: those that count right already are not copied.
		expect(trunk?.indices.buffer).toBe(plant.meshes[0].indices.buffer);
	});

	it("stands organs where they grew, those without a mesh left out, and says what bears each", () => {
		const leaf = [...partsOf(plant)].find(({ name }) => name === "Leaf");
		const { transforms, each } = leaf?.shape?.instances ?? { transforms: new Float32Array() };
		expect(transforms).toEqual(
			Float32Array.from([...plant.organs.transforms.subarray(0, 16), ...plant.organs.transforms.subarray(24)]),
		);
		expect([0, 1, 2].map((index) => each?.(index))).toEqual([
			{ name: "Leaf 001", extras: { segment: 0 } },
			{ name: "Leaf 002", extras: { segment: 1 } },
			{ name: "Leaf 003", extras: { segment: 1 } },
		]);
	});

	it("shares one material among the parts of a kind: the model's own, or a standard one", () => {
		const own: Material = { name: "Birch", colour: [0.8, 0.8, 0.75], roughness: 0.7 };
		const materials = [...partsOf(plant, { bark: own })].map(({ shape }) => shape?.material);
		expect(materials[0]).toBe(own);
		expect(materials[1]).toBe(own);
		expect(materials[2]).toBe(materials[3]);
		expect(materials[2]).toEqual(standardMaterial("blade"));
	});

	it("calls no two parts the same", () => {
		const twice = {
			...plant,
			meshes: [...plant.meshes, { ...plant.meshes[1] }, { ...plant.meshes[1], name: "leaf 001" }],
		};
		const names = [...everyPart(partsOf(twice))].flatMap(({ name, shape }) => {
			const { transforms, each } = shape?.instances ?? {};
			const members = Array.from({ length: each ? (transforms?.length ?? 0) / 8 : 0 }, (_, i) => each?.(i).name);
			return [name, ...members];
		});
		expect(new Set(names).size).toBe(names.length);
		expect(names).toContain("Bract 2");
	});
});
