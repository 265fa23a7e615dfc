/** Files of a bunch as Assimp opens them: as many triangles, as large, as where they were made. */
import { Box3, Vector3 } from "three";
import { beforeAll, describe, expect, it } from "vitest";
import { aboutPlant } from "../../../web/src/formats/about_plant";
import { exportObj } from "../../../web/src/formats/obj";
import { plantFile } from "../../../web/src/formats/plant_files";
import type { Part } from "../../../web/src/plant/part";
import { bunchModel } from "../app/context";
import { specimenFromPreset } from "../bunch";
import { freshCore, growBunch } from "../core/wasm";
import { load, meshesOf } from "./reading";
import { byAssimp } from "./reading_assimp";

const specimen = specimenFromPreset("redcurrant");
let parts: Part[];
let about: Awaited<ReturnType<typeof aboutPlant>>;
/** Triangles and bounds that three.js reads from the detailed GLB. */
let whole: Box3;
let triangles: number;

const file = async (ending: string, form?: string, options = {}) => {
	const made = await plantFile(ending, form)?.make(parts, about, options);
	if (!made) throw new Error(`no ${ending}`);
	return made;
};

/** How far corners are apart, as a share of the longest edge. */
function apart(one: Box3, other: Box3): number {
	const size = one.getSize(new Vector3());
	return Math.max(one.min.distanceTo(other.min), one.max.distanceTo(other.max)) / Math.max(size.x, size.y, size.z);
}

beforeAll(async () => {
	const grown = growBunch(await freshCore(), specimen, { stemSides: 5, berrySegments: 8 });
	parts = [...bunchModel.parts(grown, specimen)];
	about = await aboutPlant(bunchModel, grown, specimen);
	const { scene } = await load(await file("glb"));
	scene.updateMatrixWorld(true);
	whole = new Box3().setFromObject(scene, true);
	triangles = meshesOf(scene).reduce((sum, { geometry }) => sum + (geometry.index?.count ?? 0) / 3, 0);
});

describe("Assimp", () => {
	it("finds the detailed GLB's triangles where three.js does", async () => {
		const found = await byAssimp({ "a.glb": await file("glb") });
		expect(found.triangles).toBe(triangles);
		expect(apart(whole, found.bounds)).toBeLessThan(1e-5);
	});

	it("finds no more triangles in a low GLB than were asked for, as far out", async () => {
		const found = await byAssimp({ "a.glb": await file("glb", "low", { triangles: 5000 }) });
		expect(found.triangles).toBeGreaterThan(4500);
		expect(found.triangles).toBeLessThanOrEqual(5000);
		expect(apart(whole, found.bounds)).toBeLessThan(0.03);
	});

	it("finds the same in OBJ with its MTL and pictures", async () => {
		const { obj, mtl, pictures } = exportObj(parts, about, "a");
		const texts = { "a.obj": new TextEncoder().encode(obj), "a.mtl": new TextEncoder().encode(mtl) };
		const found = await byAssimp({ ...texts, ...Object.fromEntries(pictures.map(({ name, bytes }) => [name, bytes])) });
		expect(found.triangles).toBe(triangles);
		expect(apart(whole, found.bounds)).toBeLessThan(1e-4);
	});

	it("finds one body in STL and 3MF, in millimetres with +Z up, as large as the bunch", async () => {
		const upright = new Box3(
			new Vector3(1000 * whole.min.x, -1000 * whole.max.z, 1000 * whole.min.y),
			new Vector3(1000 * whole.max.x, -1000 * whole.min.z, 1000 * whole.max.y),
		);
		const bytes = await file("stl", undefined, { thickness: 2 });
		const stl = await byAssimp({ "a.stl": bytes });
		const threeMf = await byAssimp({ "a.3mf": await file("3mf", undefined, { thickness: 2 }) });
		expect(stl.triangles).toBe(new DataView(bytes.buffer).getUint32(80, true));
		expect(threeMf.triangles).toBe(stl.triangles);
		expect(apart(upright, stl.bounds)).toBeLessThan(0.03);
		expect(apart(stl.bounds, threeMf.bounds)).toBeLessThan(1e-4);
	});
});
