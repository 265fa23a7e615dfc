import { describe, expect, it } from "vitest";
import { toLch } from "../../../web/src/plant/colour";
import { leafTints, undersideOf } from "../../../web/src/plant/leaf_colours";

const LOOK = { leaf: "4a7030", autumn: "a8702c" };

describe("leafTints", () => {
	it.each([0, 0.2, 0.4])("differ by at most a tenth in lightness and 0.05 in hue until summer: season %s", (season) => {
		const tints = leafTints({ ...LOOK, season }).map(({ colour }) => toLch(colour));
		const mean = (of: (tint: (typeof tints)[number]) => number) =>
			tints.reduce((sum, tint) => sum + of(tint), 0) / tints.length;
		for (const { lightness, hue } of tints) {
			expect(Math.abs(lightness / mean((tint) => tint.lightness) - 1)).toBeLessThan(0.11);
			expect(Math.abs(hue - mean((tint) => tint.hue))).toBeLessThan(0.055);
		}
	});

	it("turn one after the other in autumn, in the order of the tints", () => {
		const hues = leafTints({ ...LOOK, season: 0.7 }).map(({ colour }) => toLch(colour).hue);
		expect(hues[5]).toBeLessThan(hues[0]);
	});
});

describe("undersideOf", () => {
	it("is never darker than the upper side, and much lighter for willow and olive", () => {
		for (const kind of ["oak", "beech", "birch", "maple", "lime", "vine", "willow", "olive", "apple", undefined])
			for (const factor of undersideOf(kind)) expect(factor).toBeGreaterThanOrEqual(1);
		expect(undersideOf("olive")[0]).toBeGreaterThan(undersideOf("beech")[0]);
	});
});
