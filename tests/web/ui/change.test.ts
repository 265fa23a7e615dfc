import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { apply, otherSeed } from "../../../web/src/ui/change";
import { BUNCH, specimenFromPreset } from "../bunch";

const bunch = specimenFromPreset("grape-15c");

describe("apply", () => {
	it("changes only the values in the change", () => {
		const next = apply(BUNCH, bunch, { seed: 9, parameters: { l: 300 }, look: { bloom: 0.25 } });
		expect(next).toEqual({
			...bunch,
			seed: 9,
			parameters: { ...bunch.parameters, l: 300 },
			look: { ...bunch.look, bloom: 0.25 },
		});
	});

	it("replaces details", () => {
		const thinned = apply(BUNCH, bunch, { details: { thinned: [3, 1] } });
		expect(thinned).toEqual({ ...bunch, thinned: [3, 1] });
		expect(apply(BUNCH, thinned, { parameters: { l: 300 } }).thinned).toEqual([3, 1]);
	});

	it("keeps every value in its range", () => {
		const next = apply(BUNCH, bunch, { parameters: { l: 9999, p3w: -5 } }).parameters;
		expect([next.l, next.p3w]).toEqual([580, 0]);
	});
});

it("another random seed always differs", () => {
	fc.assert(
		fc.property(fc.nat(0xffffffff), fc.double({ min: 0, max: 1, maxExcluded: true, noNaN: true }), (seed, dice) => {
			const other = otherSeed(seed, () => dice);
			expect(other).not.toBe(seed);
			expect(Number.isInteger(other) && other >= 1 && other <= 99_999).toBe(true);
		}),
	);
	expect(otherSeed(99_999, () => 0.999_999)).toBe(1);
});
