import { describe, expect, it } from "vitest";
import { growsAlike, sameSpecimen } from "../../../web/src/specimen/same";
import { type Specimen, specimenFromPreset, thin } from "../bunch";

const bunch: Specimen = { ...specimenFromPreset(undefined, 1), inputs: { m: 3, n: [1, 2] } };

/** Bunches that differ from it in one thing each. */
const others: Record<string, Specimen> = {
	seed: { ...bunch, seed: 2 },
	parameter: { ...bunch, parameters: { ...bunch.parameters, l: bunch.parameters.l + 1 } },
	m: { ...bunch, inputs: { m: 4, n: [1, 2] } },
	"a value of n": { ...bunch, inputs: { m: 3, n: [1, 3] } },
	"the order of n": { ...bunch, inputs: { m: 3, n: [2, 1] } },
	"the length of n": { ...bunch, inputs: { m: 3, n: [1, 2, 0] } },
	"no n": { ...bunch, inputs: { m: 3 } },
	"no inputs": { ...bunch, inputs: undefined },
	"a berry taken off": thin(bunch, 7),
	grammar: { ...bunch, grammar: "axiom: F" },
};

describe("two specimens", () => {
	it("are the same however they came to be, and what is undefined is not there", () => {
		expect(sameSpecimen(bunch, structuredClone(bunch))).toBe(true);
		expect(sameSpecimen(bunch, { ...bunch, grammar: undefined })).toBe(true);
		expect(sameSpecimen({ ...bunch, grammar: undefined }, bunch)).toBe(true);
	});

	it.each(Object.entries(others))("are others by %s, seen from either side, and grow otherwise", (_, other) => {
		expect(sameSpecimen(bunch, other)).toBe(false);
		expect(sameSpecimen(other, bunch)).toBe(false);
		expect(growsAlike(bunch, other)).toBe(false);
		expect(growsAlike(other, bunch)).toBe(false);
	});

	it("grow alike in other colours; another preset may bring another text", () => {
		const painted: Specimen = { ...bunch, look: { ...bunch.look, skin: "112233" } };
		expect(sameSpecimen(bunch, painted)).toBe(false);
		expect(growsAlike(bunch, painted)).toBe(true);
		expect(growsAlike({ ...bunch, preset: "duku" }, bunch)).toBe(false);
	});
});
