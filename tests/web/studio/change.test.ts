import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { specimenFromPreset } from "../../../web/src/specimen/from_preset";
import { apply, asPrinted, growsAlike, isAsPrinted, lockSides, otherSeed } from "../../../web/src/studio/change";
import type { Locks } from "../../../web/src/studio/types";

const free: Locks = { leftRight: false, frontBack: false };
const locked: Locks = { leftRight: true, frontBack: true };
const bunch = specimenFromPreset("grape-15c");

describe("apply", () => {
	it("changes what the change names and nothing else", () => {
		const next = apply(bunch, { seed: 9, parameters: { l: 300 }, look: { bloom: 0.25 } }, free);
		expect(next).toEqual({
			...bunch,
			seed: 9,
			parameters: { ...bunch.parameters, l: 300 },
			look: { ...bunch.look, bloom: 0.25 },
		});
	});

	it("carries a locked side along", () => {
		const next = apply(bunch, { parameters: { p4w: 77, p5r: 88 } }, locked).parameters;
		expect([next.p3w, next.p4w, next.p5r, next.p6r]).toEqual([77, 77, 88, 88]);
		expect(next.p3r).toBe(bunch.parameters.p3r);
	});

	it("leaves a locked side alone where the change names both, as a drag with the other side's own value does", () => {
		const next = apply(bunch, { parameters: { p3w: 10, p4w: 20 } }, locked).parameters;
		expect([next.p3w, next.p4w]).toEqual([10, 20]);
	});

	it("keeps every value in its range", () => {
		const next = apply(bunch, { parameters: { l: 9999, p3w: -5 } }, free).parameters;
		expect([next.l, next.p3w]).toEqual([580, 0]);
	});
});

describe("as printed", () => {
	it("sets fit and vary to 0 and back to what they were", () => {
		const mine = apply(bunch, { parameters: { fit: 0.5, vary: 0.1 } }, free);
		const printed = apply(mine, asPrinted(mine, true), free);
		expect(isAsPrinted(printed)).toBe(true);
		expect(apply(printed, asPrinted(printed, false, { fit: 0.5, vary: 0.1 }), free)).toEqual(mine);
	});

	it("goes back to the preset's where nothing is remembered", () => {
		const printed = apply(bunch, asPrinted(bunch, true), free);
		expect(apply(printed, asPrinted(printed, false), free)).toEqual(bunch);
	});
});

it("locking brings the left to the right and the back to the front", () => {
	const { p3w, p3r, p5w, p5r } = bunch.parameters;
	expect(lockSides(bunch, "leftRight")).toEqual({ parameters: { p4w: p3w, p4r: p3r } });
	expect(lockSides(bunch, "frontBack")).toEqual({ parameters: { p6w: p5w, p6r: p5r } });
});

it("another seed differs, whatever the dice say", () => {
	fc.assert(
		fc.property(fc.nat(0xffffffff), fc.double({ min: 0, max: 1, maxExcluded: true, noNaN: true }), (seed, dice) => {
			const other = otherSeed(seed, () => dice);
			expect(other).not.toBe(seed);
			expect(Number.isInteger(other) && other >= 1 && other <= 99_999).toBe(true);
		}),
	);
	expect(otherSeed(99_999, () => 0.999_999)).toBe(1);
});

it("colours grow nothing; anything else does", () => {
	expect(growsAlike(bunch, { ...bunch, look: { ...bunch.look, skin: "ffffff" } })).toBe(true);
	expect(growsAlike(bunch, { ...bunch, seed: 2 })).toBe(false);
	expect(growsAlike(bunch, { ...bunch, grammar: "axiom: F" })).toBe(false);
	expect(growsAlike(bunch, apply(bunch, { parameters: { sag: 3 } }, free))).toBe(false);
});
