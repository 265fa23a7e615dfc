import { describe, expect, it } from "vitest";
import { standardMaterial } from "../../../web/src/plant/material";

describe("standardMaterial", () => {
	it.each(["stem", "bark", "root", "blade", "petal", "sepal", "stamen", "skin", "tendril"])(
		"has something for %s",
		(kind) => {
			const { name, colour, roughness } = standardMaterial(kind);
			expect(name.toLowerCase()).toBe(kind);
			expect(Math.min(...colour)).toBeGreaterThan(0);
			expect(Math.max(...colour)).toBeLessThan(1);
			expect(roughness).toBeGreaterThan(0.2);
			expect(roughness).toBeLessThanOrEqual(1);
		},
	);

	it("has a plain green for a kind of any name, those that every object has too", () => {
		for (const kind of ["constructor", "toString", "__proto__"])
			expect(standardMaterial(kind)).toMatchObject({ roughness: 0.75, colour: standardMaterial("other").colour });
	});

	it("shows sheets from both sides, and skin as the smoothest", () => {
		expect(["blade", "petal", "sepal"].map((kind) => standardMaterial(kind).doubleSided)).toEqual([true, true, true]);
		expect(standardMaterial("bark").doubleSided).toBeUndefined();
		expect(standardMaterial("skin").roughness).toBeLessThan(standardMaterial("blade").roughness);
	});
});
