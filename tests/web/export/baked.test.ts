import { describe, expect, it } from "vitest";
import { baked } from "../../../web/src/export/baked";
import { exportGlb } from "../../../web/src/export/glb";
import { encoded } from "../../../web/src/plant/colour";
import type { Picture } from "../../../web/src/plant/material";
import { everyPart, type Part, type Shape } from "../../../web/src/plant/part";
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

/** What a picture shows at a place, 0 … 255. */
function pixel({ width, height, pixels }: Picture, u: number, v: number): number[] {
	const at = 3 * (Math.floor(v * height) * width + Math.floor(u * width));
	return [...pixels.subarray(at, at + 3)];
}

describe("colours and shade, baked", () => {
	it("are pictures that show at each vertex what it had, apart from each other", () => {
		const before = shapesOf(shaded());
		const after = shapesOf(baked(shaded()));
		for (const [i, { mesh, material }] of after.slice(0, 2).entries()) {
			expect([mesh.colours, mesh.sky]).toEqual([undefined, undefined]);
			const { colour, occlusion } = material.textures ?? {};
			const { colours = new Float32Array(0) } = before[i].mesh;
			for (let vertex = 0; vertex < 4; vertex++) {
				const [u, v] = mesh.uvs.subarray(2 * vertex, 2 * vertex + 2);
				const wanted = encoded([...colours.subarray(3 * vertex, 3 * vertex + 3)] as [number, number, number]);
				const shown = pixel(colour as Picture, u, v);
				wanted.forEach((value, k) => {
					expect(Math.abs(shown[k] - 255 * value)).toBeLessThan(6);
				});
				const open = vertex === 0 ? bounced(0.2, (0.5 + 0.25 + 0.1) / 3) : 1;
				expect(Math.abs(pixel(occlusion as Picture, u, v)[0] - 255 * open)).toBeLessThan(6);
			}
		}
		expect(after[0].material).toBe(after[1].material);
		expect(after[0].mesh.uvs).not.toEqual(after[1].mesh.uvs);
		expect(after[0].material).toMatchObject({ name: PULP.name, roughness: PULP.roughness });
	});

	it("leave no pixel of a tile bare, so that none shows at a seam", () => {
		const [{ material }] = shapesOf(baked(shaded()));
		const { colour } = material.textures ?? {};
		const { width, height, pixels } = colour as Picture;
		expect([width, height].every((edge) => Number.isInteger(Math.log2(edge)))).toBe(true);
		const black = Array.from(
			{ length: width * height },
			(_, i) => pixels[3 * i] + pixels[3 * i + 1] + pixels[3 * i + 2],
		);
		expect(black.filter((sum) => sum === 0)).toEqual([]);
	});

	it("leave alone what has no colours, and what goes on beyond one picture", () => {
		const parts = shaded();
		const long = shapesOf(parts)[1];
		long.mesh = { ...long.mesh, uvs: long.mesh.uvs.map((value) => 3 * value) };
		const after = shapesOf(baked(parts));
		expect(after[1]).toBe(long);
		expect(after[2]).toBe(shapesOf(parts)[2]);
		expect(after[0].mesh.colours).toBeUndefined();
	});

	it("are a GLB's pictures of base colour and occlusion, of which the validator has nothing to say", async () => {
		const glb = exportGlb(baked(shaded()), ABOUT);
		expect(await complaints(glb)).toEqual([]);
		const { materials = [], meshes = [] } = documentOf(glb);
		expect(materials[0]).toMatchObject({
			pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 1], baseColorTexture: { index: 0 } },
			occlusionTexture: { index: 1 },
		});
		const [one, other] = meshes.map(({ primitives }) => primitives[0]);
		expect(one.attributes).not.toHaveProperty("COLOR_0");
		expect(one.indices).toBe(other.indices);
	});
});
