import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { fromHex, fromLch, toLch } from "../../../web/src/scene/colour";
import { berryTint, hashFraction, skinOf } from "../../../web/src/scene/skin";
import { LOOK, RIPE } from "./sample_bunch";

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

	it("draws grey where the colour cannot be read", () => {
		expect(fromHex("plum")).toEqual(fromHex("808080"));
		expect(fromHex("#43264f")).toEqual(fromHex("43264f"));
	});
});

describe("berryTint", () => {
	const skin = of("43264f");
	it("gives a berry the same tint for ever, and its neighbour another", () => {
		expect(berryTint(skin, 17, RIPE)).toEqual(berryTint(of("43264f"), 17, RIPE));
		expect(berryTint(skin, 17, RIPE)).not.toEqual(berryTint(skin, 18, RIPE));
	});

	it("stays near the skin's colour", () => {
		const own = toLch(skin.ripe);
		for (let i = 0; i < 500; i++) {
			const { ripe, bloom, phase } = berryTint(skin, i, RIPE);
			const lch = toLch(ripe);
			expect(Math.abs(lch.lightness - own.lightness)).toBeLessThan(0.1);
			expect(bloom).toBeGreaterThan(0.4);
			expect(bloom).toBeLessThan(1.6);
			expect(phase >= 0 && phase < 1).toBe(true);
		}
	});

	it("is the look's own colour, in sun and shade alike, where nothing is uneven", () => {
		const even = skinOf({ ...LOOK, uneven: 0 });
		for (const exposure of [0, 1]) {
			const { ripe, unripe } = berryTint(even, 5, { ...RIPE, exposure });
			for (let k = 0; k < 3; k++) expect(ripe[k]).toBeCloseTo(even.ripe[k], 4);
			for (let k = 0; k < 3; k++) expect(unripe[k]).toBeCloseTo(even.unripe[k], 4);
		}
	});

	it("turns pale berries golden in the sun", () => {
		const pale = of("a9b04e");
		const hue = (exposure: number) => toLch(berryTint(pale, 3, { ...RIPE, exposure }).ripe).hue;
		expect(hue(1)).toBeLessThan(hue(0));
	});

	it("makes a raisin brown, dull and rid of most wax, of a pale berry as of a dark one", () => {
		for (const colour of ["a9b04e", "43264f"]) {
			const fresh = berryTint(of(colour), 8, RIPE);
			const raisin = berryTint(of(colour), 8, { ...RIPE, shrivel: 1 });
			expect(raisin.bloom).toBeLessThan(fresh.bloom);
			expect(raisin.ripe[0]).toBeGreaterThan(raisin.ripe[2]);
		}
	});

	it("draws from a hash that is even", () => {
		let sum = 0;
		const bins = new Array(10).fill(0);
		for (let i = 0; i < 5000; i++) {
			const value = hashFraction(i, 2);
			sum += value;
			bins[Math.floor(value * 10)]++;
		}
		expect(sum / 5000).toBeCloseTo(0.5, 1);
		for (const bin of bins) expect(Math.abs(bin - 500)).toBeLessThan(110);
	});
});

describe("OKLCh", () => {
	it("goes there and back", () => {
		const channel = fc.double({ min: 0.001, max: 1, noNaN: true });
		fc.assert(
			fc.property(channel, channel, channel, (r, g, b) => {
				const back = fromLch(toLch([r, g, b]));
				[r, g, b].forEach((value, k) => {
					expect(back[k]).toBeCloseTo(value, 3);
				});
			}),
		);
	});
});
