import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { lab, measureOf, skinClass } from "../../../../web/src/models/bunch/measures";
import {
	MEASURE_GROUPS,
	MEASURE_KEYS,
	MEASURES,
	SKIN_COLOUR,
} from "../../../../web/src/models/bunch/measures.generated";
import { classOf, classText, measureText } from "../../../../web/src/specimen/measures";

const info = (key: (typeof MEASURE_KEYS)[number]) => MEASURES[MEASURE_KEYS.indexOf(key)];

describe("the table", () => {
	it("names every measure once and puts it in a group that is shown", () => {
		expect(MEASURES.map(({ key }) => key)).toEqual(MEASURE_KEYS);
		expect(new Set(MEASURE_KEYS).size).toBe(MEASURE_KEYS.length);
		const groups = MEASURE_GROUPS.map(({ key }) => key);
		for (const { group } of MEASURES) expect(groups).toContain(group);
	});

	it("marks the limits of every descriptor as unchecked", () => {
		for (const { oiv, unchecked } of MEASURES) if (oiv) expect(unchecked).toBeTruthy();
	});
});

describe("measureOf", () => {
	it("reads by key; returns NaN without measures", () => {
		const measures = new Float32Array(MEASURE_KEYS.length);
		measures[MEASURE_KEYS.indexOf("bunch_weight")] = 320;
		expect(measureOf(measures, "bunch_weight")).toBe(320);
		expect(measureOf(undefined, "bunch_weight")).toBeNaN();
		expect(measureOf(new Float32Array(1), "bunch_weight")).toBeNaN();
	});
});

describe("classes", () => {
	it.each([
		["bunch_length", 10, "1 very short"],
		["bunch_length", 139, "3 short"],
		["bunch_length", 141, "5 medium"],
		["bunch_length", 900, "9 very long"],
		["density", 6.4, "7 dense"],
		["wings", 0, "1 none"],
		["wings", 1, "2 one or two"],
		["wings", 2, "2 one or two"],
		["wings", 4, "3 three or four"],
		["wings", 12, "5 more than six"],
		["berry_shape", 10, "10 finger-shaped"],
		["coverage", 0.9, ""],
		["berry_weight", Number.NaN, ""],
	] as const)("%s of %d is %s", (key, value, text) => expect(classText(info(key), value)).toBe(text));

	it("never fall as the value grows", () => {
		const classed = MEASURES.filter(({ classes }) => classes);
		const value = fc.float({ min: -10, max: 2000, noNaN: true });
		fc.assert(
			fc.property(fc.constantFrom(...classed), value, value, (measure, a, b) => {
				const [low, high] = a < b ? [a, b] : [b, a];
				expect(classOf(measure, low)?.note).toBeLessThanOrEqual(classOf(measure, high)?.note ?? 0);
			}),
		);
	});
});

describe("measureText", () => {
	it.each([
		["bunch_length", 181.6, "182 mm"],
		["coverage", 0.9413, "94.1 %"],
		["berry_count", 120, "120"],
		["berry_count", 116_880, "116,880"],
		["bunch_weight", 12_345.6, "12,346 g"],
		["bunch_shape", 2, "conical"],
		["compactness", 1.239, "1.24 g/cm²"],
		["bunch_weight", Number.NaN, "–"],
	] as const)("%s of %d reads %s", (key, value, text) => expect(measureText(info(key), value)).toBe(text));
});

describe("CIELAB", () => {
	it.each([
		["000000", [0, 0, 0]],
		["ffffff", [100, 0, 0]],
		["ff0000", [53.24, 80.09, 67.2]],
		["00ff00", [87.73, -86.18, 83.18]],
		["0000ff", [32.3, 79.19, -107.86]],
		["808080", [53.59, 0, 0]],
	])("of #%s is %j, as tables have it", (colour, expected) => {
		for (const [index, value] of lab(colour).entries()) expect(Math.abs(value - expected[index])).toBeLessThan(0.03);
	});
});

describe("skinClass", () => {
	it.each([
		["9fae55", "green-yellow"],
		["c2a551", "green-yellow"],
		["9c3a4e", "red"],
		["d6928c", "rose"],
		["8b777c", "grey"],
		["4a1c35", "dark red-violet"],
		["2c2a4f", "blue-black"],
		["33254a", "blue-black"],
	])("#%s is %s", (skin, words) => expect(skinClass({ skin }).words).toBe(words));

	it("gives each named colour its own class", () => {
		for (const one of SKIN_COLOUR.classes) for (const skin of one.like) expect(skinClass({ skin })).toEqual(one);
	});

	it("classes any colour", () => {
		const colour = fc.integer({ min: 0, max: 0xffffff }).map((value) => value.toString(16).padStart(6, "0"));
		fc.assert(
			fc.property(colour, (skin) => {
				expect(skinClass({ skin }).note).toBeGreaterThan(0);
			}),
		);
	});
});
