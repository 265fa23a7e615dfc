import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { withVolumes, writtenVolumes } from "../../../../../web/src/models/growth/volumes/footprint";
import type { GrowthVolume } from "../../../../../web/src/models/growth/volumes/volume";

const ONE: GrowthVolume = { id: 1, base: 4, height: 10, top: 2.5, middle: 3.25, gradient: 0, towards: 0, at: [0, 0] };

describe("the growth volumes of a text", () => {
	it("are read if they are numbers, with named arguments", () => {
		expect(writtenVolumes("footprint -> GrowVol(1, 1, 4, 10, 2.5, 0)\n")).toEqual([ONE]);
		const text =
			"gs = 8\nfootprint -> GrowVol(1, 1, 4, 10, 2.5, 0)\n   GrowVol(1, 2, 3, 6, .5, 10°, towards(-90), wm(5), at(1, -2.5))";
		expect(writtenVolumes(text)).toEqual([
			ONE,
			{ id: 2, base: 3, height: 6, top: 0.5, middle: 5, gradient: 10, towards: -90, at: [1, -2.5] },
		]);
	});

	it("are not, where chance or an expression has a part in them, or there are none", () => {
		for (const text of [
			"footprint -> GrowVol(cnt.rand(3), size.rand(10, 8, 12, 60°))",
			"footprint -> GrowVol(1, 1, 4, 2 * 5, 2.5, 0)",
			"footprint -> GrowVol(3, 1, 4, 10, 2.5, 0)",
			"footprint -> GrowVol(1, 1, 4, 10, 2.5, 0, at.rand(1, 2))",
			"footprint -> GrowVol(1, 1, 4, 10, 2.5, 0) GrowVol(h(3))",
			// The second's place is computed.
			"footprint -> GrowVol(1, 1, 4, 10, 2.5, 0) GrowVol(1, 2, 4, 10, 2.5, 0)",
			"/* footprint -> GrowVol(1, 1, 4, 10, 2.5, 0) */",
			"",
		])
			expect(writtenVolumes(text), text).toBeUndefined();
	});

	it("lean in the core's default direction if none is given", () => {
		const text = "footprint -> GrowVol(1, 1, 4, 10, 2, 9)\nfootprint -> GrowVol(1, 2, 4, 10, 2, 9, at(3, 0))";
		expect(writtenVolumes(text)?.map(({ towards }) => towards)).toEqual([0, 137.5]);
	});

	it("replace the previous ones, and change nothing else of the text", () => {
		const text =
			'gs = 7 /* footprint -> GrowVol(9) */\n\nfootprint -> GrowVol(cnt.rand(3), size(4, (1 + 9), 2, 0)),\n GrowVol(1)\ntree -> DivFunc("sigma1"){branches}\n';
		expect(
			withVolumes(text, [
				{ ...ONE, towards: 137.5 },
				{ ...ONE, id: 2, at: [1.005, -0.004] },
			]),
		).toBe(
			'gs = 7 /* footprint -> GrowVol(9) */\n\nfootprint -> GrowVol(1, 1, 4, 10, 2.5, 0, towards(137.5), at(0, 0))\n             GrowVol(1, 2, 4, 10, 2.5, 0, towards(0), at(1, 0))\ntree -> DivFunc("sigma1"){branches}\n',
		);
	});

	it("are one footprint's where there were two, and are written where there was none", () => {
		const two =
			'footprint -> GrowVol(1, 1, 2, 3, 4, 5)\ntree -> DivFunc("sigma1"){branches}\nfootprint -> GrowVol(2)\ngs = 3\n';
		expect(withVolumes(two, [ONE])).toBe(
			'footprint -> GrowVol(1, 1, 4, 10, 2.5, 0, towards(0), at(0, 0))\ntree -> DivFunc("sigma1"){branches}\ngs = 3\n',
		);
		expect(writtenVolumes(withVolumes("gs = 3", [ONE]))).toEqual([ONE]);
	});

	it("are read as they were written, to the centimetre, whatever they are", () => {
		const hundredths = (most: number) => fc.integer({ min: -most, max: most }).map((value) => value / 100 + 0);
		const size = fc.integer({ min: 1, max: 100_000 }).map((value) => value / 100);
		const volume = fc.record({
			id: fc.nat(1000),
			base: size,
			height: size,
			top: size,
			middle: size,
			gradient: hundredths(8000),
			towards: hundredths(36000),
			at: fc.tuple(hundredths(100_000), hundredths(100_000)),
		});
		fc.assert(
			fc.property(fc.array(volume, { minLength: 1, maxLength: 5 }), fc.string(), (volumes, before) => {
				const text = withVolumes(`/*${before.replaceAll("*/", "")}*/`, volumes);
				expect(writtenVolumes(text)).toEqual(volumes);
				expect(withVolumes(text, volumes)).toBe(text);
			}),
		);
	});
});
