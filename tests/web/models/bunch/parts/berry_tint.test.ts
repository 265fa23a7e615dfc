import { describe, expect, it } from "vitest";
import { berryTint, tintOf } from "../../../../../web/src/models/bunch/parts/berry_tint";
import { skinOf } from "../../../../../web/src/models/bunch/parts/skin";
import { toLch } from "../../../../../web/src/plant/colour";
import { pressedBunch } from "../pressed_bunch";
import { LOOK, RIPE } from "../sample_bunch";

const of = (skin: string, bloom = 0.3) => skinOf({ ...LOOK, skin, bloom }, "grape", true);

describe("berryTint", () => {
	const skin = of("43264f");
	it("always gives a berry the same tint, and its neighbour another", () => {
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

	it("is the look's colour, in sun and shade, if nothing is uneven", () => {
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

	it("makes raisins of pale grapes amber, those of dark ones a redder brown", () => {
		const raisin = (colour: string) => toLch(berryTint(of(colour), 8, { ...RIPE, shrivel: 1 }).ripe);
		const [pale, dark] = [raisin("a9b04e"), raisin("43264f")];
		expect(pale.hue - dark.hue).toBeGreaterThan(0.15);
		expect(pale.hue).toBeLessThan(1.25);
		expect(pale.chroma).toBeGreaterThan(dark.chroma);
	});

	it("lets a few berries ripen late, redder than chance makes any", () => {
		const uneven = skinOf({ ...LOOK, skin: "43264f", uneven: 1 });
		const own = toLch(uneven.ripe);
		const reddened = Array.from({ length: 2000 }, (_, id) => toLch(berryTint(uneven, id, RIPE).ripe).hue - own.hue);
		const late = reddened.filter((turn) => turn > 0.24).length / reddened.length;
		expect(late).toBeGreaterThan(0.03);
		expect(late).toBeLessThan(0.07);
		// None goes as far the other way.
		expect(Math.min(...reddened)).toBeGreaterThan(-0.23);
	});
});

describe("tintOf", () => {
	it("uses a natural berry's sun, age and drying; the paper's berries get half the sun", () => {
		const pale = of("a9b04e");
		const natural = pressedBunch({ count: 2, exposure: 1, set: 0.5, shrivel: 0.25 });
		const id = natural.berries.ids[1];
		expect(tintOf(natural, 1, pale)).toEqual(berryTint(pale, id, { exposure: 1, set: 0.5, shrivel: 0.25 }));
		const paper: typeof natural = { ...natural, procedure: "paper" };
		expect(tintOf(paper, 1, pale)).toEqual(berryTint(pale, id, { exposure: 0.5, set: 0.5, shrivel: 0.25 }));
	});
});
