import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { fromHex, fromLch, toLch } from "../../../web/src/scene/colour";
import { berryTint, hashFraction, skinOf } from "../../../web/src/scene/skin";

const of = (skin: string, bloom = 0.3) => skinOf({ skin, stem: "7d7a3f", bloom });

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
		expect(white.translucency).toBeGreaterThan(0.5);
		expect(redcurrant.translucency).toBeGreaterThan(0.5);
		expect(dark.translucency).toBeLessThan(0.3);
		for (const rind of [duku, longan, lychee]) {
			expect(rind.roughness).toBeGreaterThan(0.5);
			expect(rind.translucency).toBeLessThan(0.35);
		}
		for (const taut of [white, redcurrant, dark, of("c2a551"), of("9c3a4e")]) expect(taut.roughness).toBeLessThan(0.1);
	});

	it("passes red best through dark flesh and green best through a white grape", () => {
		const [r, g, b] = of("2c2a4f").absorption;
		expect(r).toBeLessThan(Math.min(g, b));
		const white = of("9fae55").absorption;
		expect(white[1]).toBeLessThan(Math.min(white[0], white[2]));
	});

	it("gives numbers a shader can take for any colour at all", () => {
		const hex = fc.integer({ min: 0, max: 0xffffff }).map((value) => value.toString(16).padStart(6, "0"));
		fc.assert(
			fc.property(hex, fc.double(), (colour, bloom) => {
				const skin = of(colour, bloom);
				const numbers = [...skin.base, ...skin.absorption, ...skin.wax, skin.translucency, skin.roughness];
				for (const value of numbers) expect(Number.isFinite(value) && value >= 0).toBe(true);
				expect(skin.translucency).toBeLessThanOrEqual(1);
			}),
		);
	});

	it("draws grey where the colour cannot be read", () => {
		expect(fromHex("plum")).toEqual(fromHex("808080"));
		expect(fromHex("#43264f")).toEqual(fromHex("43264f"));
	});
});

describe("berryTint", () => {
	const skin = of("43264f");
	it("gives a berry the same tint for ever, and its neighbour another", () => {
		expect(berryTint(skin, 17)).toEqual(berryTint(of("43264f"), 17));
		expect(berryTint(skin, 17)).not.toEqual(berryTint(skin, 18));
	});

	it("stays near the skin's colour", () => {
		const own = toLch(skin.base);
		for (let i = 0; i < 500; i++) {
			const { colour, bloom, phase } = berryTint(skin, i);
			const lch = toLch(colour);
			expect(Math.abs(lch.lightness - own.lightness)).toBeLessThan(0.1);
			expect(bloom).toBeGreaterThan(0.4);
			expect(bloom).toBeLessThan(1.6);
			expect(phase >= 0 && phase < 1).toBe(true);
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
