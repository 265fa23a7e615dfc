import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { baked } from "../../../web/src/formats/baked";
import { exportGlb } from "../../../web/src/formats/glb";
import { tangentsOf } from "../../../web/src/formats/tangents";
import { encoded } from "../../../web/src/plant/colour";
import type { Picture } from "../../../web/src/plant/material";
import { everyPart, type Part, type Shape, type SurfaceDetail, type Vector } from "../../../web/src/plant/part";
import { bounced } from "../../../web/src/plant/shade";
import { complaints, documentOf } from "./reading";
import { ABOUT, fruits, PULP } from "./toy_parts";

const shapesOf = (parts: Part[]) => [...everyPart(parts)].flatMap(({ shape }) => shape ?? []);
const shaded = (): Part[] =>
	fruits().map((group) => ({
		...group,
		children: group.children?.map((part) => {
			const shape = part.shape as Shape;
			return { ...part, shape: { ...shape, mesh: { ...shape.mesh, sky: Uint8Array.of(51, 255, 255, 255) } } };
		}),
	}));

/** The value of a picture at a point, 0 … 255. */
function pixel({ width, height, pixels }: Picture, u: number, v: number): number[] {
	const at = 3 * (Math.floor(v * height) * width + Math.floor(u * width));
	return [...pixels.subarray(at, at + 3)];
}

describe("colours and shade, baked", () => {
	it("are pictures that show at each vertex what it had, apart from each other", async () => {
		const before = shapesOf(shaded());
		const after = shapesOf(await baked(shaded()));
		for (const [i, { mesh, material }] of after.slice(0, 2).entries()) {
			expect([mesh.colours, mesh.sky]).toEqual([undefined, undefined]);
			const { colour, surface } = material.textures ?? {};
			const { colours = new Float32Array(0) } = before[i].mesh;
			for (let vertex = 0; vertex < 4; vertex++) {
				const [u, v] = mesh.uvs.subarray(2 * vertex, 2 * vertex + 2);
				const wanted = encoded([...colours.subarray(3 * vertex, 3 * vertex + 3)] as [number, number, number]);
				const shown = pixel(colour as Picture, u, v);
				wanted.forEach((value, k) => {
					expect(Math.abs(shown[k] - 255 * value)).toBeLessThan(6);
				});
				const open = vertex === 0 ? bounced(0.2, (0.5 + 0.25 + 0.1) / 3) : 1;
				const [shade, rough, metal] = pixel(surface as Picture, u, v);
				expect(Math.abs(shade - 255 * open)).toBeLessThan(6);
				expect([rough, metal]).toEqual([Math.round(255 * PULP.roughness), 0]);
			}
		}
		expect(after[0].material).toBe(after[1].material);
		expect(after[0].mesh.uvs).not.toEqual(after[1].mesh.uvs);
		expect(after[0].material).toMatchObject({ name: PULP.name, roughness: PULP.roughness });
	});

	it("leave no pixel of a tile bare, so that none shows at a seam", async () => {
		const [{ material }] = shapesOf(await baked(shaded()));
		const { colour } = material.textures ?? {};
		const { width, height, pixels } = colour as Picture;
		expect([width, height].every((edge) => Number.isInteger(Math.log2(edge)))).toBe(true);
		const black = Array.from(
			{ length: width * height },
			(_, i) => pixels[3 * i] + pixels[3 * i + 1] + pixels[3 * i + 2],
		);
		expect(black.filter((sum) => sum === 0)).toEqual([]);
	});

	it("leave alone what has no colours, and what goes on beyond one picture", async () => {
		const parts = shaded();
		const long = shapesOf(parts)[1];
		long.mesh = { ...long.mesh, uvs: long.mesh.uvs.map((value) => 3 * value) };
		const after = shapesOf(await baked(parts));
		expect(after[1]).toBe(long);
		expect(after[2]).toBe(shapesOf(parts)[2]);
		expect(after[0].mesh.colours).toBeUndefined();
	});

	it("are a GLB's pictures of base colour and of occlusion, roughness and metal in one, of which the validator has nothing to say", async () => {
		const glb = exportGlb(await baked(shaded()), ABOUT);
		expect(await complaints(glb)).toEqual([]);
		const { materials = [], meshes = [], textures = [] } = documentOf(glb);
		expect(textures).toHaveLength(2);
		expect(materials[0]).toMatchObject({
			pbrMetallicRoughness: {
				baseColorFactor: [1, 1, 1, 1],
				baseColorTexture: { index: 0 },
				metallicRoughnessTexture: { index: 1 },
				roughnessFactor: 1,
				metallicFactor: 0,
			},
			occlusionTexture: { index: 1 },
		});
		expect(materials[0]).not.toHaveProperty("normalTexture");
		const [one, other] = meshes.map(({ primitives }) => primitives[0]);
		expect(one.attributes).not.toHaveProperty("COLOR_0");
		expect(one.indices).toBe(other.indices);
	});
});

describe("what is finer than vertices, baked", () => {
	const TILTED: Vector = [0.36, 0.48, 0.8];
	const finer = (relief: boolean): SurfaceDetail => ({
		relief,
		at: (_, [first]) => ({ roughness: first, ...(relief ? { normal: TILTED } : {}) }),
	});
	/** The first fruit has a relief, the second one none. */
	const rough = (): Part[] =>
		shaded().map((group) => ({
			...group,
			children: group.children?.map((part, i) => ({
				...part,
				shape: { ...(part.shape as Shape), loadDetail: async () => finer(i === 0) },
			})),
		}));

	it("is roughness at each place, in place of the material's", async () => {
		const [{ mesh, material }] = shapesOf(await baked(rough()));
		const surface = material.textures?.surface as Picture;
		const middle = [0, 1].map((k) => (mesh.uvs[k] + mesh.uvs[2 + k] + mesh.uvs[4 + k]) / 3);
		expect(Math.abs(pixel(surface, middle[0], middle[1])[1] - 255 / 3)).toBeLessThan(4);
		expect(pixel(surface, mesh.uvs[0], mesh.uvs[1])[1]).toBeGreaterThan(245);
	});

	it("is normals in the frame of the tangents that the file has; what has no relief keeps its own", async () => {
		const shapes = shapesOf(await baked(rough()));
		const normals = shapes[0].material.textures?.normal as Picture;
		for (const [i, { mesh }] of shapes.slice(0, 2).entries()) {
			const tangents = tangentsOf(mesh);
			for (let vertex = 0; vertex < 4; vertex++) {
				const [u, v] = mesh.uvs.subarray(2 * vertex, 2 * vertex + 2);
				const [x, y, z] = pixel(normals, u, v).map((value) => value / 127.5 - 1);
				const own = new Vector3().fromArray(mesh.normals, 3 * vertex);
				const right = new Vector3().fromArray(tangents, 4 * vertex);
				const up = own
					.clone()
					.cross(right)
					.multiplyScalar(tangents[4 * vertex + 3]);
				const shown = right.multiplyScalar(x).addScaledVector(up, y).addScaledVector(own, z).normalize();
				const wanted = i === 0 ? new Vector3(...TILTED) : own;
				expect((180 / Math.PI) * shown.angleTo(wanted)).toBeLessThan(6);
			}
		}
		const glb = exportGlb(await baked(rough()), ABOUT);
		expect(await complaints(glb)).toEqual([]);
		const { materials = [], meshes = [] } = documentOf(glb);
		expect(materials[0]).toMatchObject({ normalTexture: { index: 2 } });
		expect(meshes[0].primitives[0].attributes).toHaveProperty("TANGENT");
	});
});
