import { Box3, type Mesh, type MeshPhongMaterial } from "three";
import { describe, expect, it } from "vitest";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { load, meshesOf } from "../../../formats/reading";
import { loadObj } from "../../../formats/reading_obj";
import { SKETCH } from "../fixture";
import { makeNatural } from "../natural_fixture";
import { bunchGlb, bunchObj } from "./files";
import { specimen } from "./natural_reading";

const grown = makeNatural(SKETCH, { traits: (i) => ({ turned: i / 2, opened: 1, set: i === 1 ? 0.25 : 1 }) });

function read(from: BunchPlant): Mesh[] {
	return meshesOf(loadObj(bunchObj(from, specimen, "bunch")));
}

const material = ({ material }: Mesh) => material as MeshPhongMaterial;

describe("the OBJ of a natural bunch", () => {
	it("has the GLB's names, one object for each berry, flower and leaf", () => {
		expect(read(grown).map(({ name }) => name)).toEqual([
			...["Rachis", "Axis_01", "Axis_02", "Axis_03", "Berry_001", "Berry_002", "Flower_002", "Berry_003"],
			...["Cane", "Petiole_1", "Leaf_1", "Petiole_2", "Leaf_2"],
		]);
	});

	it("has the GLB's triangles and bounds", async () => {
		const { scene } = await load(await bunchGlb(grown, specimen));
		const written = read(grown);
		const corners = (meshes: Mesh[]) =>
			meshes.reduce((sum, { geometry }) => sum + (geometry.index ?? geometry.attributes.position).count, 0);
		expect(corners(written)).toBe(corners(meshesOf(scene)));
		const box = new Box3();
		for (const mesh of written) box.expandByObject(mesh, true);
		const expected = new Box3().setFromObject(scene, true);
		expect(box.min.distanceTo(expected.min) + box.max.distanceTo(expected.max)).toBeLessThan(4e-6);
	});

	it("has a material per quarter of ripeness, each with its berries' mean colour", () => {
		const berries = read(grown).filter(({ name }) => name.startsWith("Berry"));
		expect(berries.map((mesh) => material(mesh).name)).toEqual(["Skin_0", "Skin_50", "Skin"]);
		const [unripe, , ripe] = berries.map((mesh) => material(mesh).color);
		expect(unripe.g).toBeGreaterThan(unripe.b);
		expect(ripe.getHSL({ h: 0, s: 0, l: 0 }).l).toBeLessThan(unripe.getHSL({ h: 0, s: 0, l: 0 }).l);
	});

	it("names every material it uses, and no other", () => {
		const { obj, mtl } = bunchObj(grown, specimen, "bunch");
		const words = (text: string, keyword: string) =>
			[...text.matchAll(new RegExp(`^${keyword} (.+)$`, "gm"))].map(([, name]) => name);
		expect(new Set(words(obj, "usemtl"))).toEqual(new Set(words(mtl, "newmtl")));
		expect(words(mtl, "newmtl")).toContain("Leaf");
	});
});
