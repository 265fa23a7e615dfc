import { describe, expect, it } from "vitest";
import { FRUIT_SKINS } from "../../../../../web/src/models/bunch/parts/fruit_skin";
import { foliageMaterials, naturalSkin, plainSkin } from "../../../../../web/src/models/bunch/parts/materials";
import { linear } from "../../../../../web/src/plant/colour";
import { LOOK } from "../sample_bunch";

const skin = (look: Partial<typeof LOOK>, fruit: keyof typeof FRUIT_SKINS = "grape") =>
	naturalSkin({ ...LOOK, ...look }, FRUIT_SKINS[fruit], linear(look.skin ?? LOOK.skin), 0.018);

describe("materials of berries", () => {
	it("is duller under bloom, dullest under a rind", () => {
		const [clean, half, bloomed] = [0, 0.5, 1].map((bloom) => skin({ bloom }).roughness);
		expect(clean).toBeCloseTo(0.34);
		expect(half).toBeCloseTo((clean + bloomed) / 2);
		expect(bloomed).toBeCloseTo(0.46);
		for (const bloom of [0, 1]) {
			expect(plainSkin({ ...LOOK, bloom }).roughness).toBeCloseTo(skin({ bloom }).roughness);
			expect(skin({ bloom }, "lychee").roughness).toBeGreaterThan(0.7);
		}
	});

	it("has wax's pale blue sheen as far as there is bloom, and none without", () => {
		expect(skin({ bloom: 0 }).sheen).toBeUndefined();
		const [red, , blue] = skin({ bloom: 1 }).sheen?.colour ?? [1, 1, 0];
		expect(blue).toBeGreaterThan(red);
		expect(skin({ bloom: 0.5 }).sheen?.colour[2]).toBeCloseTo(blue / 2);
		expect(skin({ bloom: 1 }).specular).toBeCloseTo(0.2);
	});

	it("lets light through where the skin is pale and glows, one way through leaving its colour", () => {
		const pale = skin({ skin: "c9b04e", glow: 1 });
		expect(pale.flesh).toMatchObject({ thickness: 0.018, distance: 0.018 });
		expect(Math.max(...(pale.flesh?.colour ?? []))).toBe(1);
		expect(skin({ skin: "c9b04e", glow: 0 }).flesh).toBeUndefined();
		expect(skin({ skin: "1d1c30", glow: 1 }).flesh).toBeUndefined();
		expect(skin({ skin: "c9b04e", glow: 1 }, "lychee").flesh).toBeUndefined();
	});

	it("is a blade seen from both sides in leaves alone, which turn in autumn", () => {
		const [green, gold] = [foliageMaterials(0), foliageMaterials(1)];
		expect([green.leaf, green.cane, green.petiole].map(({ doubleSided = false }) => doubleSided)).toEqual([
			true,
			false,
			false,
		]);
		// Paler below while green; alike once turned.
		expect(Math.min(...(green.leaf.sheet?.reverse ?? []))).toBeGreaterThan(1.05);
		expect(gold.leaf.sheet?.reverse).toEqual([1, 1, 1]);
	});
});
