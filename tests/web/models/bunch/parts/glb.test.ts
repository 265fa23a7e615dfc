import { readFileSync } from "node:fs";
import fc from "fast-check";
import { Box3, type InstancedMesh, Matrix4, type Mesh, type MeshPhysicalMaterial, Quaternion, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { inRun } from "../../../../long_run.mjs";
import { writtenSpecimen } from "../../../bunch";
import { basesOf, complaints, documentOf, load, meshesOf } from "../../../formats/reading";
import * as arbitrary from "../arbitrary";
import { makeGrown, paperSpecimen, SKETCH } from "../fixture";
import { bunchGlb } from "./files";

const grown = makeGrown(SKETCH);
const specimen = paperSpecimen({ preset: "short-conical", seed: 7 });

describe("the GLB", () => {
	it("is valid for any growth and specimen", async () => {
		await fc.assert(
			fc.asyncProperty(arbitrary.sketch, arbitrary.specimen, fc.boolean(), async (sketch, any, instancing) => {
				expect(await complaints(await bunchGlb(makeGrown(sketch), any, { instancing }))).toEqual([]);
			}),
			{ numRuns: inRun(40, 150) },
		);
	});

	it("names plant, stems and berries", async () => {
		const { nodes, meshes, materials } = documentOf(await bunchGlb(grown, specimen));
		const names = (indices: number[] = []) => indices.map((index) => nodes[index].name);
		expect(nodes[0].name).toBe("Bunch short-conical");
		expect(names(nodes[0].children)).toEqual(["Rachis", "Axis 01", "Axis 02", "Axis 03", "Berries"]);
		const berries = nodes.find(({ name }) => name === "Berries");
		expect(names(berries?.children)).toEqual(["Berry 001", "Berry 002", "Berry 003"]);
		expect(meshes?.map(({ name }) => name)).toEqual(["Rachis", "Axis 01", "Axis 02", "Axis 03", "Berry"]);
		expect(materials?.map(({ name }) => name)).toEqual(["Stem", "Skin"]);
	});

	it("is read by three.js with every name, one mesh for each axis and one that all berries share", async () => {
		const { scene } = await load(await bunchGlb(grown, specimen));
		const meshes = meshesOf(scene);
		// three.js gives objects names without spaces and keeps the written ones beside them.
		expect(scene.children[0].userData.name).toBe("Bunch short-conical");
		const named = (start: string) => meshes.filter(({ userData }) => userData.name.startsWith(start));
		expect(named("Axis ")).toHaveLength(3);
		expect(new Set(named("Berry ").map(({ geometry }) => geometry)).size).toBe(1);
		const triangles = [...named("Rachis"), ...named("Axis ")].reduce(
			(sum, { geometry }) => sum + triangleCount(geometry),
			0,
		);
		expect(triangles).toBe((grown.stem?.indices.length ?? 0) / 3);
		expect(meshes.every(({ geometry }) => geometry.attributes.normal && geometry.attributes.uv)).toBe(true);
	});

	it("puts the same triangles where the growth has them", async () => {
		const { scene } = await load(await bunchGlb(grown, specimen));
		const corners = meshesOf(scene)
			.filter(({ userData }) => !userData.name.startsWith("Berr"))
			.flatMap(({ geometry }) =>
				Array.from(geometry.index?.array ?? [], (i) => [...geometry.attributes.position.array.slice(3 * i, 3 * i + 3)]),
			);
		const { positions, indices } = grown.stem ?? { positions: [], indices: [] };
		expect(corners).toEqual(Array.from(indices, (i) => [...positions.slice(3 * i, 3 * i + 3)]));
	});

	it("brings every berry back in place, size and direction", async () => {
		const { scene } = await load(await bunchGlb(grown, specimen));
		const berries = meshesOf(scene).filter(({ userData }) => userData.name.startsWith("Berry "));
		expect(berries).toHaveLength(grown.berries.count);
		scene.updateMatrixWorld(true);
		berries.forEach((berry, index) => {
			expectBerry(berry.matrixWorld, index);
			const pedicel = grown.berries.parent[index];
			expect(berry.userData).toMatchObject({ pedicel, axis: grown.internodes.axis[pedicel] });
		});
	});

	it("turns the shared berry along any direction", async () => {
		await fc.assert(
			fc.asyncProperty(arbitrary.direction, async (direction) => {
				const one = makeGrown({ axes: [[{ direction, berryRadius: 0.006 }]] });
				const { nodes } = documentOf(await bunchGlb(one, specimen));
				const rotation = nodes.find(({ name }) => name === "Berry 001")?.rotation as [number, number, number, number];
				const up = new Vector3(0, 1, 0).applyQuaternion(new Quaternion(...rotation));
				expect(up.distanceTo(new Vector3(...one.berries.directions))).toBeLessThan(1e-6);
			}),
		);
	});

	it("has the growth's bounding box", async () => {
		const { scene } = await load(await bunchGlb(grown, specimen));
		const expected = new Box3().setFromArray(grown.stem?.positions ?? []);
		for (let i = 0; i < grown.berries.count; i++) {
			const [x, y, z, r] = grown.berries.spheres.subarray(4 * i);
			for (const vertex of berryCorners(i)) expected.expandByPoint(vertex);
			expect(expected.distanceToPoint(new Vector3(x, y, z))).toBeLessThan(r);
		}
		const box = new Box3().setFromObject(scene, true);
		expect(box.min.distanceTo(expected.min)).toBeLessThan(1e-6);
		expect(box.max.distanceTo(expected.max)).toBeLessThan(1e-6);
	});

	it("keeps the specimen, its link, the plan and the counts in asset.extras", async () => {
		const link = "https://example.org/?v=2&preset=short-conical&seed=7";
		const { asset } = await load(await bunchGlb(grown, specimen, { link }));
		const { procedure, plan, counts, fingerprint } = grown;
		expect(asset.extras).toEqual({ link, specimen: writtenSpecimen(specimen), procedure, plan, counts, fingerprint });
		expect(asset.copyright).toBeUndefined();
		const packed = JSON.parse(readFileSync("package.json", "utf8"));
		expect(asset.generator).toBe(`Panicle ${packed.version}`);
	});

	it("writes the query as link where there is no address, and a second bunch's plan where there is one", async () => {
		const { extras } = documentOf(await bunchGlb({ ...grown, second: grown.plan }, specimen)).asset;
		expect(extras.link).toBe("?v=2&preset=short-conical&seed=7&procedure=paper");
		expect(extras.plan).toEqual({ ...grown.plan, second: grown.plan });
	});

	it("colours skin and stem, in linear light", async () => {
		const coloured = paperSpecimen({ look: { ...specimen.look, skin: "ff8000", stem: "007fff", bloom: 0 } });
		const { Skin, Stem: stem } = basesOf(await bunchGlb(grown, coloured));
		expect(Skin).toEqual([1, expect.closeTo(0.215861, 6), 0, 1]);
		// Stems are coloured by vertex, between green and wood; the brightest is the base.
		expect(stem[0]).toBe(0);
		expect(stem[1] / 0.212231).toBeGreaterThan(0.7);
		expect(stem[1] / 0.212231).toBeLessThan(1.2);
		expect(stem[2]).toBeGreaterThan(0.7);
	});

	it("shows bloom as a sheen that grows with it, and none without", async () => {
		const sheen = async (bloom: number) => {
			const { scene } = await load(await bunchGlb(grown, paperSpecimen({ look: { ...specimen.look, bloom } })));
			const skin = meshesOf(scene).at(-1)?.material as MeshPhysicalMaterial;
			return skin.sheenColor?.b ?? 0;
		};
		expect(await sheen(0)).toBe(0);
		expect(await sheen(1)).toBeGreaterThan(await sheen(0.5));
		expect(
			documentOf(await bunchGlb(grown, paperSpecimen({ look: { ...specimen.look, bloom: 0 } }))).extensionsUsed,
		).toBeUndefined();
	});

	it("browns the berry's tip and leaves the rest its colour", async () => {
		const { scene } = await load(await bunchGlb(grown, specimen));
		const { geometry } = meshesOf(scene).at(-1) as Mesh;
		const red = (vertex: number) => geometry.attributes.color.getX(vertex);
		expect(red(0)).toBe(1);
		expect(red(geometry.attributes.position.count - 1)).toBeLessThan(0.6);
	});

	it("counts with 16 bits while it can and with 32 where it must", async () => {
		const large = makeGrown({ ...SKETCH, segments: 400 });
		const types = (glb: Uint8Array) => documentOf(glb).accessors?.map(({ componentType }) => componentType);
		expect(types(await bunchGlb(grown, specimen))).not.toContain(5125);
		const glb = await bunchGlb(large, specimen);
		expect(types(glb)).toContain(5125);
		expect(await complaints(glb)).toEqual([]);
	});

	it("omits parts that a growth does not have", async () => {
		const bare = documentOf(await bunchGlb(makeGrown({ axes: [] }), specimen, { instancing: true }));
		expect(bare.nodes.map(({ name }) => name)).toEqual(["Bunch short-conical", "Rachis"]);
		expect(bare.materials).toHaveLength(1);
		expect(bare.extensionsUsed).toBeUndefined();
		const { stem, berry, ...skeleton } = grown;
		await expect(bunchGlb(skeleton, specimen)).rejects.toThrow("This bunch has no meshes to export");
		const empty = {
			...grown,
			stem: { ...stem, parts: [] },
			berries: { ...grown.berries, count: 0 },
			berry,
		} as typeof grown;
		// A plant of which everything was cut is a node with nothing in it, of which the validator informs.
		expect((await complaints(await bunchGlb(empty, specimen))).map(({ code }) => code)).toEqual(["NODE_EMPTY"]);
	});

	it("is the same bytes for the same growth, which it leaves as it was", async () => {
		const before = structuredClone(grown);
		expect(await bunchGlb(grown, specimen)).toEqual(await bunchGlb(makeGrown(SKETCH), specimen));
		expect(grown).toEqual(before);
	});
});

describe("the GLB with instances", () => {
	it("requires EXT_mesh_gpu_instancing and has one node Berries", async () => {
		const document = documentOf(await bunchGlb(grown, specimen, { instancing: true }));
		expect(document.extensionsRequired).toEqual(["EXT_mesh_gpu_instancing"]);
		expect(document.nodes.map(({ name }) => name)).toEqual([
			"Bunch short-conical",
			"Rachis",
			"Axis 01",
			"Axis 02",
			"Axis 03",
			"Berries",
		]);
	});

	it("brings every berry back in three.js in place, size and direction", async () => {
		const { scene } = await load(await bunchGlb(grown, specimen, { instancing: true }));
		const berries = meshesOf(scene).at(-1) as InstancedMesh;
		expect(berries.isInstancedMesh).toBe(true);
		expect(berries.count).toBe(grown.berries.count);
		const matrix = new Matrix4();
		for (let i = 0; i < berries.count; i++) {
			berries.getMatrixAt(i, matrix);
			expectBerry(matrix, i);
		}
	});
});

function triangleCount(geometry: Mesh["geometry"]): number {
	return (geometry.index?.count ?? 0) / 3;
}

function expectBerry(matrix: Matrix4, index: number): void {
	const [position, rotation, scale] = [new Vector3(), new Quaternion(), new Vector3()];
	matrix.decompose(position, rotation, scale);
	const [x, y, z, r] = grown.berries.spheres.subarray(4 * index, 4 * index + 4);
	expect(position.distanceTo(new Vector3(x, y, z))).toBeLessThan(1e-6);
	expect(scale.distanceTo(new Vector3(r, r, r))).toBeLessThan(1e-6);
	const towards = new Vector3(0, 1, 0).applyQuaternion(rotation);
	expect(towards.distanceTo(new Vector3(...grown.berries.directions.subarray(3 * index, 3 * index + 3)))).toBeLessThan(
		1e-6,
	);
}

/** The vertices of berry `index`, turned by a way of our own: three.js's shortest arc from −Y after half a turn about X. */
function berryCorners(index: number): Vector3[] {
	const [x, y, z, r] = grown.berries.spheres.subarray(4 * index, 4 * index + 4);
	const direction = new Vector3(...grown.berries.directions.subarray(3 * index, 3 * index + 3));
	const turn = new Quaternion()
		.setFromUnitVectors(new Vector3(0, -1, 0), direction)
		.multiply(new Quaternion(1, 0, 0, 0));
	const { positions } = grown.berry ?? { positions: new Float32Array() };
	return Array.from({ length: positions.length / 3 }, (_, i) =>
		new Vector3(...positions.subarray(3 * i, 3 * i + 3))
			.applyQuaternion(turn)
			.multiplyScalar(r)
			.add(new Vector3(x, y, z)),
	);
}
