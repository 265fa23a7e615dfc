import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { NUMBER_KEYS } from "../../../web/src/models/bunch/parameters.generated";
import { withSeed } from "../../../web/src/specimen/edit";
import { change, startHistory, undo } from "../../../web/src/specimen/history";
import { growsAlike, sameSpecimen } from "../../../web/src/specimen/same";
import { apply } from "../../../web/src/ui/change";
import { BUNCH, MAX_THINNED, specimenFromPreset, thin, unthin, unthinAll, withLook, withParameters } from "../bunch";
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
		expect(withLook(specimen, { skin: "abcdef" }).look.skin).toBe("abcdef");
		for (const key of ["bloom", "glow", "uneven", "lenticels"] as const) {
			expect(withLook(specimen, { [key]: 7 }).look[key]).toBe(1);
			expect(withLook(specimen, { [key]: 0.333 }).look[key]).toBe(0.33);
		}
		expect(withSeed(specimen, 4294967296).seed).toBe(0);
		expect(withSeed(specimen, -1).seed).toBe(4294967295);
	});

	it("leave what they do not say as the same object", () => {
		const specimen = specimenFromPreset();
		const aged = apply(BUNCH, specimen, { parameters: { age: 10 } });
		expect(aged.look).toBe(specimen.look);
		expect(apply(BUNCH, specimen, { look: { skin: "abcdef" } }).parameters).toBe(specimen.parameters);
	});

	it("keep a choice among its options", () => {
		const fruit = (value: number) => withParameters(specimenFromPreset(), { fruit: value }).parameters.fruit;
		expect([-1, 0, 2.4, 5, 99].map(fruit)).toEqual([0, 0, 2, 5, 5]);
	});

	it("leave the specimen they start from alone", () => {
		const specimen = specimenFromPreset();
		thin(specimen, 3);
		withLook(withParameters(specimen, { l: 100 }), { skin: "ffffff" });
		expect(specimen).toEqual(specimenFromPreset());
	});
});

describe("thinning by hand", () => {
	it("takes berries off in order, each once, and puts them back", () => {
		const specimen = thin(thin(thin(specimenFromPreset(), 9), 4), 7);
		expect(specimen.thinned).toEqual([9, 4, 7]);
		expect(thin(specimen, 4)).toBe(specimen);
		expect(unthin(specimen, 4).thinned).toEqual([9, 7]);
		expect(unthin(specimen, 5)).toBe(specimen);
		expect(unthinAll(specimen)).toEqual(specimenFromPreset());
		expect(unthinAll(specimenFromPreset()).thinned).toEqual([]);
	});

	it("ends at as many as a link holds", () => {
		const full = { ...specimenFromPreset(), thinned: Array.from({ length: MAX_THINNED }, (_, id) => id) };
		expect(thin(full, 1000)).toBe(full);
		expect(thin(unthin(full, 0), 1000).thinned.at(-1)).toBe(1000);
	});

	it("is a step that can be undone", () => {
		const before = specimenFromPreset();
		const history = change(startHistory(before), thin(before, 3));
		expect(history.past).toHaveLength(1);
		expect(undo(history).present).toEqual(before);
	});
});

describe("sameSpecimen", () => {
	it("sees every difference that a link would", () => {
		const specimen = specimenFromPreset();
		expect(sameSpecimen(specimen, structuredClone(specimen))).toBe(true);
		const others = [
			withParameters(specimen, { vary: 0 }),
			withLook(specimen, { bloom: 0.2 }),
			withSeed(specimen, 2),
			{ ...specimen, preset: "duku" },
			{ ...specimen, inputs: { m: 3 } },
			{ ...specimen, inputs: { m: 3, n: [1, 2] } },
			{ ...specimen, grammar: "axiom: F" },
			thin(specimen, 1),
			withParameters(specimen, { procedure: 0 }),
		];
		for (const other of others) expect(sameSpecimen(specimen, other)).toBe(false);
		expect(sameSpecimen({ ...specimen, thinned: [1, 2] }, { ...specimen, thinned: [2, 1] })).toBe(false);
	});
});

it("colours grow nothing; anything else does", () => {
	const bunch = specimenFromPreset("grape-15c");
	expect(growsAlike(bunch, withLook(bunch, { skin: "ffffff" }))).toBe(true);
	expect(growsAlike(bunch, withSeed(bunch, 2))).toBe(false);
	expect(growsAlike(bunch, { ...bunch, grammar: "axiom: F" })).toBe(false);
	expect(growsAlike(bunch, withParameters(bunch, { sag: 3 }))).toBe(false);
});
