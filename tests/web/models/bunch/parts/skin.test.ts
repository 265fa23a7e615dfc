import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { skinOf } from "../../../../../web/src/models/bunch/parts/skin";
import { LOOK } from "../sample_bunch";

const of = (skin: string, bloom = 0.3) => skinOf({ ...LOOK, skin, bloom }, "grape", true);

describe("skinOf", () => {
	it("lets light through pale and vivid skins, less through dark ones, hardly through rinds", () => {
		const [white, redcurrant, dark, duku, longan, lychee] = [
			"a9b04e",
			"b8121c",
			"2c2a4f",
			"d3b778",
			"ae8747",
			"b4473f",
		].map((hex) => of(hex));
		expect(white.ripeFlesh.translucency).toBeGreaterThan(0.5);
		expect(redcurrant.ripeFlesh.translucency).toBeGreaterThan(0.5);
		expect(dark.ripeFlesh.translucency).toBeLessThan(0.3);
		for (const rind of [duku, longan, lychee]) {
			expect(rind.fruit.rind).toBeGreaterThan(0.5);
			expect(rind.ripeFlesh.translucency).toBeLessThan(0.35);
		}
		for (const taut of [white, redcurrant, dark, of("c2a551"), of("9c3a4e")]) expect(taut.fruit.rind).toBeLessThan(0.1);
	});

	it("passes red best through dark flesh and green best through a white grape", () => {
		const [r, g, b] = of("2c2a4f").ripeFlesh.absorption;
		expect(r).toBeLessThan(Math.min(g, b));
		const white = of("9fae55").ripeFlesh.absorption;
		expect(white[1]).toBeLessThan(Math.min(white[0], white[2]));
	});

	it("takes more light away in dark flesh than in pale", () => {
		const sum = (hex: string) => of(hex).ripeFlesh.absorption.reduce((all, one) => all + one);
		expect(sum("1d1c30")).toBeGreaterThan(3 * sum("c9b04e"));
		expect(sum("1d1c30") - Math.log(0.12 * 0.16)).toBeGreaterThan(4);
		expect(Math.min(...of("1d1c30").ripeFlesh.absorption)).toBeGreaterThan(0.9);
	});

	it("gives numbers a shader can take for any colour at all", () => {
		const hex = fc.integer({ min: 0, max: 0xffffff }).map((value) => value.toString(16).padStart(6, "0"));
		fc.assert(
			fc.property(hex, fc.double(), (colour, bloom) => {
				const skin = of(colour, bloom);
				const numbers = [
					...skin.ripe,
					...skin.ripeFlesh.absorption,
					...skin.wax,
					skin.ripeFlesh.translucency,
					skin.fruit.rind,
				];
				for (const value of numbers) expect(Number.isFinite(value) && value >= 0).toBe(true);
				expect(skin.ripeFlesh.translucency).toBeLessThanOrEqual(1);
			}),
		);
	});

	it("lets more light through the higher `glow`, none at 0", () => {
		const at = (glow: number) => skinOf({ ...LOOK, skin: "c2b05a", glow }).ripeFlesh.translucency;
		expect(at(0)).toBe(0);
		expect(at(0.3)).toBeLessThan(at(0.6));
	});

	it("knows a natural fruit's rind by its kind, not by its colour", () => {
		expect(skinOf({ ...LOOK, skin: "b4473f" }, "grape").fruit.rind).toBe(0);
		const lychee = skinOf({ ...LOOK, skin: "b4473f" }, "lychee");
		expect(lychee.fruit.rind).toBeGreaterThan(0.5);
		expect(lychee.ripeFlesh.translucency).toBeLessThan(0.15);
	});
});
