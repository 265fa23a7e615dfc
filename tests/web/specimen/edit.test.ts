import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { withLook, withParameters, withSeed } from "../../../web/src/specimen/edit";
import { specimenFromPreset } from "../../../web/src/specimen/from_preset";
import { NUMBER_KEYS } from "../../../web/src/specimen/parameters.generated";
import { sameSpecimen } from "../../../web/src/specimen/same";
import { anySpecimen, faults } from "./arbitrary";

describe("edits", () => {
	it("keep any specimen valid, whatever a control says", () => {
		const changes = fc.dictionary(fc.constantFrom(...NUMBER_KEYS), fc.double());
		fc.assert(
			fc.property(anySpecimen, changes, (specimen, change) => {
				expect(faults(withParameters(specimen, change))).toEqual([]);
			}),
		);
	});

	it("let the least and the greatest radius push each other along", () => {
		const specimen = specimenFromPreset();
		expect(withParameters(specimen, { rmin: 44 }).parameters).toMatchObject({ rmin: 44, rmax: 44 });
		expect(withParameters(specimen, { rmax: 11 }).parameters).toMatchObject({ rmin: 11, rmax: 11 });
	});

	it("change the look and the seed", () => {
		const specimen = specimenFromPreset();
		expect(withLook(specimen, "skin", "abcdef").look.skin).toBe("abcdef");
		expect(withLook(specimen, "bloom", 7).look.bloom).toBe(1);
		expect(withSeed(specimen, 4294967296).seed).toBe(0);
		expect(withSeed(specimen, -1).seed).toBe(4294967295);
	});

	it("leave the specimen they start from alone", () => {
		const specimen = specimenFromPreset();
		withLook(withParameters(specimen, { l: 100 }), "skin", "ffffff");
		expect(specimen).toEqual(specimenFromPreset());
	});
});

describe("sameSpecimen", () => {
	it("sees every difference that a link would", () => {
		const specimen = specimenFromPreset();
		expect(sameSpecimen(specimen, structuredClone(specimen))).toBe(true);
		const others = [
			withParameters(specimen, { vary: 0 }),
			withLook(specimen, "bloom", 0.2),
			withSeed(specimen, 2),
			{ ...specimen, preset: "duku" },
			{ ...specimen, inputs: { m: 3 } },
			{ ...specimen, inputs: { m: 3, n: [1, 2] } },
			{ ...specimen, grammar: "axiom: F" },
		];
		for (const other of others) expect(sameSpecimen(specimen, other)).toBe(false);
	});
});
