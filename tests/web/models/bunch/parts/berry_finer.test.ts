import { describe, expect, it } from "vitest";
import { exportGlb } from "../../../../../web/src/formats/glb";
import { plantFile } from "../../../../../web/src/formats/plant_files";
import type { BerrySurfaces } from "../../../../../web/src/models/bunch/bunch_plant";
import { berryFiner } from "../../../../../web/src/models/bunch/parts/berry_finer";
import { bunchParts } from "../../../../../web/src/models/bunch/parts/bunch_parts";
import { bunchSkin } from "../../../../../web/src/models/bunch/parts/skin";
import type { Look } from "../../../bunch";
import { complaints, documentOf } from "../../../formats/reading";
import { ABOUT } from "../../../formats/toy_parts";
import { type PressedOptions, pressedBunch } from "../pressed_bunch";
import { LOOK } from "../sample_bunch";

/** Returns the details of one free berry, at each of its vertices. */
function atVertices(look: Partial<Look>, options: PressedOptions = {}) {
	const grown = pressedBunch({ count: 1, ...options });
	const surfaces = grown.surfaces as BerrySurfaces;
	const finer = berryFiner(grown, 0, surfaces, bunchSkin(grown, { look: { ...LOOK, uneven: 0, ...look } }));
	const vertices = surfaces.uvs.length / 2;
	const found = Array.from({ length: vertices }, (_, vertex) => ({
		...finer.at([vertex, vertex, vertex], [1, 0, 0]),
		v: surfaces.uvs[2 * vertex + 1],
		own: [...surfaces.normals.subarray(3 * vertex, 3 * vertex + 3)],
	}));
	return { finer, found, middle: found.filter(({ v }) => Math.abs(v - 0.5) < 0.3) };
}

const mean = (values: number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
const roughnessOf = (found: { roughness: number }[]) => mean(found.map(({ roughness }) => roughness));

describe("a berry's skin, finer than its vertices", () => {
	it("is as smooth as its material in the mean, clean and in full bloom, and rougher where wax lies", () => {
		const clean = atVertices({ bloom: 0 }).middle;
		expect(new Set(clean.map(({ roughness }) => roughness)).size).toBe(1);
		expect(roughnessOf(clean)).toBeCloseTo(0.34, 6);
		const waxed = atVertices({ bloom: 1 }).middle;
		expect(Math.abs(roughnessOf(waxed) - 0.46)).toBeLessThan(0.04);
		const all = waxed.map(({ roughness }) => roughness);
		expect(Math.max(...all) - Math.min(...all)).toBeGreaterThan(0.05);
	});

	it("is dull on a rind, at a scar and on a raisin", () => {
		expect(roughnessOf(atVertices({ bloom: 0 }, { fruit: "longan" }).found)).toBeCloseTo(0.78, 6);
		const { found } = atVertices({ bloom: 0 });
		expect(roughnessOf(found.filter(({ v }) => v > 0.99))).toBeGreaterThan(0.6);
		expect(roughnessOf(atVertices({ bloom: 0 }, { shrivel: 1 }).middle)).toBeCloseTo(0.34 + 0.6 * 0.44, 6);
	});

	it("has a relief where the view shows one: on rinds and raisins", () => {
		expect(atVertices({}).finer.relief).toBe(false);
		expect(atVertices({}).found.every(({ normal }) => normal === undefined)).toBe(true);
		for (const options of [{ fruit: "longan" }, { shrivel: 1 }] as const) {
			const { finer, found } = atVertices({}, options);
			expect(finer.relief).toBe(true);
			const turned = found.map(({ normal = [0, 0, 0], own }) => {
				expect(Math.hypot(...normal)).toBeCloseTo(1, 6);
				return (
					(180 / Math.PI) *
					Math.acos(
						Math.min(
							1,
							normal.reduce((sum, value, k) => sum + value * own[k], 0),
						),
					)
				);
			});
			expect(mean(turned)).toBeGreaterThan(0.5);
			expect(Math.max(...turned)).toBeLessThan(40);
		}
	});

	it("becomes textures of a valid GLB; of normals only where there is a relief", async () => {
		for (const shrivel of [0, 1]) {
			const grown = pressedBunch({ count: 2, shrivel });
			const surfaces = grown.surfaces as BerrySurfaces;
			// At its poles three's sphere extends beyond its texture.
			grown.surfaces = { ...surfaces, uvs: surfaces.uvs.map((value) => Math.min(1, Math.max(0, value))) };
			const parts = [...bunchParts(grown, { look: LOOK })];
			const glb = (await plantFile("glb")?.make(parts, ABOUT, { textures: true })) as Uint8Array;
			expect(await complaints(glb)).toEqual([]);
			const skin = documentOf(glb).materials?.find(({ name }) => name === "Skin");
			const index = documentOf(glb).textures?.findIndex(({ name }) => name === "Skin surface");
			expect(skin).toMatchObject({
				pbrMetallicRoughness: { metallicRoughnessTexture: { index } },
				occlusionTexture: { index },
			});
			expect("normalTexture" in (skin ?? {})).toBe(shrivel === 1);
			// Other formats have no such textures.
			const plain = documentOf(exportGlb(parts, ABOUT)).materials?.find(({ name }) => name === "Skin");
			expect(plain).not.toHaveProperty("occlusionTexture");
		}
	});
});
