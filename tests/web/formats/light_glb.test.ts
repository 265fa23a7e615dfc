/** The light forms, of plants of several models: read back by three.js and compared with the detailed one. */
import { MeshoptDecoder } from "meshoptimizer/decoder";
import { Box3, type BufferAttribute, type InterleavedBufferAttribute, type Mesh, Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { beforeAll, describe, expect, it } from "vitest";
import { exportGlb } from "../../../web/src/formats/glb";
import { lowGlb } from "../../../web/src/formats/low_glb";
import { mergedBodies, solidGroups } from "../../../web/src/formats/merged_bodies";
import { LOW_TRIANGLES } from "../../../web/src/formats/plant_files";
import { tornAt } from "../../../web/src/formats/solid";
import { webGlb } from "../../../web/src/formats/web_glb";
import { inRun } from "../../long_run.mjs";
import { grownParts } from "./grown_parts";
import { outlineOverlap } from "./outline_overlap";
import { complaints, documentOf, meshesOf, unpictured } from "./reading";
import { silhouette, unlike } from "./silhouette";
import { ABOUT, fruits, PULP, plain, tetrahedron } from "./toy_parts";

beforeAll(() => MeshoptDecoder.ready);

async function meshesIn(glb: Uint8Array): Promise<Mesh[]> {
	const { scene } = await new GLTFLoader()
		.setMeshoptDecoder(MeshoptDecoder)
		.parseAsync(unpictured(glb).buffer as ArrayBuffer, "");
	scene.updateMatrixWorld(true);
	return meshesOf(scene);
}

function valuesOf(attribute: BufferAttribute | InterleavedBufferAttribute): Buffer {
	const { count, itemSize } = attribute;
	const value = (_: unknown, i: number) => attribute.getComponent(Math.floor(i / itemSize), i % itemSize);
	return Buffer.from(Float64Array.from({ length: count * itemSize }, value).buffer);
}

const trianglesOf = (meshes: readonly Mesh[]) =>
	meshes.reduce((sum, { geometry }) => sum + (geometry.index?.count ?? 0) / 3, 0);

function boxOf(meshes: readonly Mesh[]): Box3 {
	const box = new Box3();
	for (const mesh of meshes) box.expandByObject(mesh, true);
	return box;
}

/** How far the boxes are apart, as a share of the diagonal. */
function boxesApart(one: Box3, other: Box3): number {
	return Math.max(one.min.distanceTo(other.min), one.max.distanceTo(other.max)) / one.getSize(new Vector3()).length();
}

/** A comparison: a preset, the most bytes of its web form, and how much of the outline may differ in its low form. */
const PLANTS: [source: string, mostBytes: number, mostDifferent: number][] = [
	["root/carrot", 0.2e6, 0.01],
	["leaf/oak", 0.8e6, 0.01],
	["bunch/long-conical", 0.8e6, 0.02],
	["tree/bonsai", 5.2e6, 0.25],
];

describe.each(PLANTS.slice(0, inRun(3, 4)))("the light forms of %s", (source, mostBytes, mostDifferent) => {
	let parts: Awaited<ReturnType<typeof grownParts>>["parts"];
	let about: Awaited<ReturnType<typeof grownParts>>["about"];
	let detailed: Mesh[];
	beforeAll(async () => {
		({ parts, about } = await grownParts(source));
		detailed = await meshesIn(exportGlb(parts(), about));
	});

	it("for the web: small, few draw calls, and the same to look at", async () => {
		const [web, twin] = [await webGlb(parts(), about), await webGlb(parts(), about, false)];
		expect(web.length).toBeLessThan(mostBytes);
		const { asset, meshes, extensionsRequired = [] } = documentOf(web);
		expect(extensionsRequired.toSorted()).toEqual(["EXT_meshopt_compression", "KHR_mesh_quantization"]);
		expect(asset.extras.link).toBe(about.link);
		expect(meshes?.length).toBeLessThanOrEqual(5);
		const [unpacked, plain] = [await meshesIn(web), await meshesIn(twin)];
		for (const [i, { geometry }] of unpacked.entries()) {
			const other = plain[i].geometry;
			expect(Object.keys(geometry.attributes).toSorted()).toEqual(Object.keys(other.attributes).toSorted());
			for (const [name, attribute] of Object.entries(geometry.attributes)) {
				expect(valuesOf(attribute).equals(valuesOf(other.attributes[name])), name).toBe(true);
			}
			expect(geometry.index?.count).toBe(other.index?.count);
		}
		expect(boxesApart(boxOf(detailed), boxOf(unpacked))).toBeLessThan(0.002);
		expect(trianglesOf(unpacked)).toBeLessThan(trianglesOf(detailed));
		for (const axis of [0, 2])
			expect(unlike(silhouette(detailed, axis), silhouette(unpacked, axis))).toBeLessThan(0.006);
	});

	it("low: no more triangles than asked for, and the same outline", async () => {
		for (const budget of inRun([LOW_TRIANGLES], [LOW_TRIANGLES, 5000])) {
			const low = await lowGlb(parts(), about, budget);
			expect(documentOf(low).extensionsRequired).toBeUndefined();
			const meshes = await meshesIn(low);
			const most = Math.min(budget, trianglesOf(detailed));
			expect(trianglesOf(meshes)).toBeLessThanOrEqual(most);
			expect(trianglesOf(meshes)).toBeGreaterThan(0.5 * most);
			if (budget !== LOW_TRIANGLES) continue;
			for (const axis of [0, 2]) {
				expect(unlike(silhouette(detailed, axis), silhouette(meshes, axis))).toBeLessThan(mostDifferent);
			}
		}
	});
});

describe("the low form of a bunch", () => {
	it.each([
		[20_000, 0.97],
		[2000, 0.95],
		[500, 0.9],
	])("of at most %i triangles has %f of the outline of the detailed form", async (triangles, least) => {
		const { parts, about } = await grownParts("bunch/merlot");
		const glb = await lowGlb(parts(), about, triangles);
		expect(await complaints(glb)).toEqual([]);
		const meshes = await meshesIn(glb);
		expect(trianglesOf(meshes)).toBeLessThanOrEqual(triangles);
		expect(outlineOverlap(await meshesIn(exportGlb(parts(), about)), meshes)).toBeGreaterThanOrEqual(least);
	});
});

describe("merged bodies", () => {
	const solid = (centre: [number, number, number], shade?: number[]) => ({
		material: PULP,
		mesh: tetrahedron(centre, 1, shade && [...shade, ...shade, ...shade, ...shade]),
	});
	const sheet = { material: PULP, mesh: { ...tetrahedron([0, 3, 0], 1), indices: Uint32Array.of(0, 1, 2) } };

	it("are the solid pieces of one material; a single one and an open one keep their triangles", () => {
		expect(solidGroups([solid([0, 0, 0]), sheet]).size).toBe(0);
		const pieces = [solid([0, 0, 0]), sheet, solid([0.5, 0, 0])];
		const groups = solidGroups(pieces);
		expect([...groups]).toEqual([[PULP, [pieces[0], pieces[2]]]]);
		const [body, rest, ...more] = mergedBodies(pieces, groups, 3);
		expect([rest, more]).toEqual([sheet, []]);
		expect(tornAt(body.mesh.indices).size).toBe(0);
	});

	it("have the colours of the nearest of them", () => {
		const pieces = [solid([0, 0, 0], [1, 0, 0]), solid([4, 0, 0], [0, 0, 1])];
		const [{ mesh }] = mergedBodies(pieces, solidGroups(pieces), 3);
		const near = (vertex: number) => (mesh.positions[3 * vertex] < 2 ? [1, 0, 0] : [0, 0, 1]);
		for (let vertex = 0; vertex < mesh.positions.length / 3; vertex++) {
			expect([...(mesh.colours ?? []).slice(3 * vertex, 3 * vertex + 3)]).toEqual(near(vertex));
		}
	});
});

describe("the light forms of a plant of no model", () => {
	it.each([
		["in standard materials", plain],
		["with colours, centres and children", fruits],
		["with nothing in it", () => []],
	])("are valid %s, and the same every time", async (_, parts) => {
		for (const make of [() => webGlb(parts(), ABOUT, false), () => lowGlb(parts(), ABOUT, 100)]) {
			const glb = await make();
			expect((await complaints(glb)).filter(({ code }) => code !== "NODE_EMPTY")).toEqual([]);
			expect(Buffer.from(glb).equals(await make())).toBe(true);
		}
	});
});
