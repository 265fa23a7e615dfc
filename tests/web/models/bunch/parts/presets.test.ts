/** The paper's presets, grown by its procedure in the real core and exported in every form. */

import { readFileSync } from "node:fs";
import { Box3, type InstancedMesh, Matrix4, Vector3 } from "three";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../../web/src/core/loader";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import type { BunchRequestOptions } from "../../../../../web/src/models/bunch/request";
import { exportJson, presetsInRun, specimenFromFile, specimenFromPreset } from "../../../bunch";
import { growBunch } from "../../../core/wasm";
import { documentOf, load, meshesOf } from "../../../formats/reading";
import { loadObj } from "../../../formats/reading_obj";
import { fingerprintOfDocument } from "../fingerprint";
import { bunchGlb, bunchObj } from "./files";

let core: Core;

beforeAll(async () => {
	core = await loadCoreFromBytes(readFileSync("build/core/bunch.wasm"));
});

const specimenOf = (name: string) => specimenFromPreset(name, 1);
const grow = (name: string, options?: BunchRequestOptions) => growBunch(core, specimenOf(name), options);
/** Fewer triangles for tests of the file format: parsing OBJ is slow. */
const COARSE: BunchRequestOptions = { stemSides: 5, berrySegments: 8 };

describe.each(presetsInRun(({ kind }) => kind !== "variety"))("%s", (name) => {
	const specimen = specimenOf(name);
	let grown: BunchPlant;
	beforeAll(() => {
		grown = grow(name);
	});

	it("has a unique name for every node of a GLB in every form", async () => {
		for (const form of [{}, { instancing: true }, { compact: true }]) {
			const glb = await bunchGlb(grown, specimen, form);
			const { nodes } = documentOf(glb);
			const names = nodes.map((node) => node.name);
			expect(names.slice(0, 2)).toEqual([`Bunch ${name}`, "Rachis"]);
			expect(new Set(names).size).toBe(names.length);
			const axes = grown.stem?.parts.filter(({ axis, indexCount }) => axis >= 0 && indexCount > 0).length;
			expect(names.filter((each) => each.startsWith("Axis "))).toHaveLength(axes ?? 0);
		}
	});

	it("comes back through three.js with every berry in place, in both forms", async () => {
		const single = await load(await bunchGlb(grown, specimen));
		const instanced = await load(await bunchGlb(grown, specimen, { instancing: true }));
		single.scene.updateMatrixWorld(true);
		const berries = meshesOf(single.scene).filter(({ userData }) => userData.name.startsWith("Berry "));
		const instances = meshesOf(instanced.scene).at(-1) as InstancedMesh;
		expect([berries.length, instances.count]).toEqual([grown.berries.count, grown.berries.count]);
		const matrix = new Matrix4();
		berries.forEach((berry, index) => {
			instances.getMatrixAt(index, matrix);
			expectPlace(berry.matrixWorld, grown, index);
			expectPlace(matrix, grown, index);
		});
	});

	it("comes back through three.js from OBJ and MTL, with the GLB's triangles and bounds", async () => {
		const grown = grow(name, COARSE);
		const group = loadObj(bunchObj(grown, specimen, name));
		const { scene } = await load(await bunchGlb(grown, specimen));
		const corners = (root: typeof group) =>
			meshesOf(root).reduce((sum, { geometry }) => sum + (geometry.index ?? geometry.attributes.position).count, 0);
		expect(corners(group)).toBe(corners(scene));
		const [box, expected] = [new Box3().setFromObject(group, true), new Box3().setFromObject(scene, true)];
		expect(box.min.distanceTo(expected.min)).toBeLessThan(2e-6);
		expect(box.max.distanceTo(expected.max)).toBeLessThan(2e-6);
	});

	it("gives its fingerprint again from the JSON, and its specimen from every file that holds it", async () => {
		const json = JSON.stringify(exportJson(grown, specimen));
		expect(fingerprintOfDocument(JSON.parse(json))).toBe(grown.fingerprint);
		const files = [await bunchGlb(grown, specimen), new TextEncoder().encode(json)];
		for (const file of files) expect(await specimenFromFile(name, new Blob([file]))).toEqual({ specimen, notes: [] });
	});
});

function expectPlace(matrix: Matrix4, { berries }: BunchPlant, index: number): void {
	const [x, y, z, r] = berries.spheres.subarray(4 * index, 4 * index + 4);
	expect(new Vector3().setFromMatrixPosition(matrix).distanceTo(new Vector3(x, y, z))).toBeLessThan(1e-6);
	const tip = new Vector3(0, 1, 0).transformDirection(matrix);
	expect(tip.distanceTo(new Vector3(...berries.directions.subarray(3 * index, 3 * index + 3)))).toBeLessThan(1e-6);
	expect(new Vector3().setFromMatrixScale(matrix).distanceTo(new Vector3(r, r, r))).toBeLessThan(1e-6);
}
