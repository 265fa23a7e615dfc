import fc from "fast-check";
import { type BufferAttribute, Matrix4, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { GlbOptions } from "../../../../../web/src/formats/glb";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { MEASURE_KEYS } from "../../../../../web/src/models/bunch/measures.generated";
import { inRun } from "../../../../long_run.mjs";
import { evenly } from "../../../evenly";
import { complaints, documentOf } from "../../../formats/reading";
import * as arbitrary from "../arbitrary";
import { SKETCH } from "../fixture";
import { makeNatural, STAMENS_REACH } from "../natural_fixture";
import { bunchGlb } from "./files";
import { placeOf, read, shade, specimen } from "./natural_reading";

const grown = makeNatural(SKETCH);
const FORMS: GlbOptions[] = [{}, { compact: true }, { instancing: true }, { compact: true, instancing: true }];

describe("the GLB of a natural bunch", () => {
	it("passes Khronos' validator without messages, in any form, for any growth, age and look", async () => {
		const trait = evenly(0, 1);
		const traits = fc.record({ exposure: trait, turned: trait, opened: trait, set: trait, shrivel: trait });
		const fruit = fc.constantFrom("grape", "currant", "bramble", "lychee", "longan", "duku") as fc.Arbitrary<
			BunchPlant["form"]["fruit"]
		>;
		await fc.assert(
			fc.asyncProperty(
				arbitrary.sketch,
				arbitrary.specimen,
				traits,
				fruit,
				fc.constantFrom(...FORMS),
				fc.boolean(),
				async (sketch, any, all, kind, form, bare) => {
					const natural = makeNatural(sketch, { traits: () => all, bare });
					natural.form = { ...natural.form, fruit: kind };
					expect(await complaints(await bunchGlb(natural, any, form))).toEqual([]);
				},
			),
			{ numRuns: inRun(30, 120) },
		);
	});

	it("names everything, and gives each berry a mesh of its own", async () => {
		const { nodes, meshes, materials } = documentOf(await bunchGlb(grown, specimen));
		const names = (indices: number[] = []) => indices.map((index) => nodes[index].name);
		expect(names(nodes[0].children)).toEqual(
			"Rachis,Axis 01,Axis 02,Axis 03,Berries,Cane,Petiole 1,Leaf 1,Petiole 2,Leaf 2".split(","),
		);
		expect(names(nodes.find(({ name }) => name === "Berries")?.children)).toEqual([
			"Berry 001",
			"Berry 002",
			"Berry 003",
		]);
		expect(meshes?.filter(({ name }) => name.startsWith("Berry ")).map(({ name }) => name)).toHaveLength(3);
		expect(materials?.map(({ name }) => name)).toEqual(["Stem", "Skin", "Cane", "Petiole", "Leaf"]);
	});

	it.each([{ compact: false }, { compact: true }])("puts every vertex where the growth has it (%o)", async (form) => {
		const { named } = await read(grown, specimen, form);
		const { positions = new Float32Array(), normals = positions, uvs = positions } = grown.surfaces ?? {};
		const vertices = uvs.length / 2;
		named("Berry ").forEach((berry, i) => {
			const radius = grown.berries.spheres[4 * i + 3];
			for (let vertex = 0; vertex < vertices; vertex++) {
				const from = 3 * (i * vertices + vertex);
				const place = new Vector3(...positions.subarray(from, from + 3));
				expect(placeOf(berry, vertex).distanceTo(place)).toBeLessThan(form.compact ? radius / 10_000 : 1e-8);
				const normal = new Vector3().fromBufferAttribute(berry.geometry.attributes.normal, vertex);
				const error = normal.distanceTo(new Vector3(...normals.subarray(from, from + 3)));
				expect(error).toBeLessThan(form.compact ? 0.008 : 1e-6);
			}
		});
		const corners = [...named("Rachis"), ...named("Axis ")].flatMap((mesh) =>
			Array.from({ length: mesh.geometry.attributes.position.count }, (_, vertex) => placeOf(mesh, vertex)),
		);
		corners.forEach((corner, i) => {
			const expected = new Vector3(...(grown.stem?.positions.subarray(3 * i, 3 * i + 3) ?? []));
			expect(corner.distanceTo(expected)).toBeLessThan(1e-6);
		});
	});

	it("places each berry's node at its centre, so that it can be moved", async () => {
		for (const compact of [false, true]) {
			const { nodes } = documentOf(await bunchGlb(grown, specimen, { compact }));
			nodes
				.filter(({ name }) => name.startsWith("Berry "))
				.forEach(({ translation = [] }, i) => {
					expect(Float32Array.from(translation)).toEqual(grown.berries.spheres.slice(4 * i, 4 * i + 3));
				});
		}
	});

	it("writes texture coordinates and triangles of the pattern once", async () => {
		const { meshes } = documentOf(await bunchGlb(grown, specimen));
		const berries = meshes?.filter(({ name }) => name.startsWith("Berry ")).map(({ primitives }) => primitives[0]);
		expect(new Set(berries?.map(({ indices }) => indices)).size).toBe(1);
		expect(new Set(berries?.map(({ attributes }) => attributes.TEXCOORD_0)).size).toBe(1);
		expect(new Set(berries?.map(({ attributes }) => attributes.POSITION)).size).toBe(3);
		expect(new Set(berries?.map(({ material }) => material)).size).toBe(1);
		const { named } = await read(grown);
		const [one, other] = named("Berry ").map(({ geometry }) => geometry);
		expect((one.index as BufferAttribute).array.buffer).toBe((other.index as BufferAttribute).array.buffer);
	});

	it("contains the data of each berry", async () => {
		const { named } = await read(grown);
		named("Berry ").forEach(({ userData }, i) => {
			const pedicel = grown.berries.parent[i];
			expect(userData).toMatchObject({ id: grown.berries.ids[i], pedicel, axis: grown.internodes.axis[pedicel] });
			const [width, length, exposure, turned] = grown.berries.traits.subarray(8 * i);
			const written = [userData.radius, userData.width, userData.length, userData.exposure, userData.turned];
			expect(written.map(Math.fround)).toEqual([grown.berries.spheres[4 * i + 3], width, length, exposure, turned]);
		});
	});

	it("has the measures by key in asset.extras", async () => {
		const { extras } = documentOf(await bunchGlb(grown, specimen)).asset;
		expect(Object.keys(extras.measures as object)).toEqual(MEASURE_KEYS);
		expect(extras).toMatchObject({ procedure: "natural", fingerprint: grown.fingerprint });
	});

	it("is much smaller when compact, and lists the required extensions", async () => {
		const fine = makeNatural({ ...SKETCH, segments: 24, sides: 7 });
		const [full, compact] = await Promise.all([bunchGlb(fine, specimen), bunchGlb(fine, specimen, { compact: true })]);
		const { extensionsRequired } = documentOf(compact);
		expect(extensionsRequired).toEqual(["KHR_mesh_quantization"]);
		expect(documentOf(full).extensionsRequired).toBeUndefined();
		const vertices = (fine.surfaces?.positions.length ?? 0) / 3;
		expect(full.length - compact.length).toBeGreaterThan(10 * vertices);
	});

	it("ignores the option of instances, since its berries differ", async () => {
		expect(await bunchGlb(grown, specimen, { instancing: true })).toEqual(await bunchGlb(grown, specimen));
	});
});

describe("the flowers of a natural bunch", () => {
	const blooming = makeNatural(SKETCH, {
		traits: (i) => ({ turned: 0, opened: i === 0 ? 0 : 1, set: i === 2 ? 0.5 : 0 }),
	});

	it.each([{ compact: false }, { compact: true }])("share a mesh and hang on their berries (%o)", async (form) => {
		const { named } = await read(blooming, specimen, form);
		const flowers = named("Flower ");
		// The first is a closed bud.
		expect(flowers.map(({ userData, parent }) => [userData.name, parent?.userData.name])).toEqual([
			["Flower 002", "Berry 002"],
			["Flower 003", "Berry 003"],
		]);
		expect(new Set(flowers.map(({ geometry }) => geometry)).size).toBe(1);
		flowers.forEach(({ matrixWorld, geometry }, k) => {
			const i = k + 1;
			const [x, y, z, r] = blooming.berries.spheres.subarray(4 * i);
			expect(new Vector3().setFromMatrixPosition(matrixWorld).distanceTo(new Vector3(x, y, z))).toBeLessThan(1e-7);
			const up = new Vector3(0, 1, 0).applyMatrix4(new Matrix4().extractRotation(matrixWorld));
			expect(up.distanceTo(new Vector3(...blooming.berries.directions.subarray(3 * i, 3 * i + 3)))).toBeLessThan(1e-6);
			const reach = new Vector3().fromBufferAttribute(geometry.attributes.position, 0).length();
			const share = i === 2 ? 0.5 : 1;
			expect(reach * new Vector3().setFromMatrixScale(matrixWorld).x).toBeCloseTo(STAMENS_REACH * share * r, 6);
		});
	});

	it("have white filaments and yellow anthers, and are gone when all have set", async () => {
		const [flower] = (await read(blooming)).named("Flower ");
		const { uv } = flower.geometry.attributes;
		const blue = (quarter: number) =>
			shade(
				flower,
				Array.from({ length: uv.count }, (_, i) => i).find((i) => Math.floor(4 * uv.getY(i)) === quarter) ?? -1,
			).b;
		const [filament, anther] = [1, 2].map(blue);
		expect(anther).toBeLessThan(0.8 * filament);
		const set = documentOf(await bunchGlb(grown, specimen));
		expect([...set.nodes, ...(set.meshes ?? [])].filter(({ name }) => name.startsWith("Flower"))).toEqual([]);
		expect(set.materials?.map(({ name }) => name)).not.toContain("Flower");
	});
});
