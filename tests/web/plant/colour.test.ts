import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { type Colour, encoded, fromLch, linear, meanColour, mixed, toLch } from "../../../web/src/plant/colour";

const hex = fc.integer({ min: 0, max: 0xffffff }).map((bits) => bits.toString(16).padStart(6, "0"));
const bytes = (colour: Colour) =>
	colour
		.map((value) =>
			Math.round(255 * value)
				.toString(16)
				.padStart(2, "0"),
		)
		.join("");

describe("colours", () => {
	it("decode sRGB as IEC 61966-2-1 has it", () => {
		expect(linear("ff8000")).toEqual([1, expect.closeTo(0.215861, 6), 0]);
		expect(linear("#0a0a0a")[0]).toBeCloseTo(10 / 255 / 12.92, 9);
	});

	it("come back from linear light as they were", () => {
		fc.assert(
			fc.property(hex, (colour) => {
				expect(bytes(encoded(linear(colour)))).toBe(colour);
			}),
		);
	});

	it("that cannot be read are grey", () => {
		for (const bad of ["", "red", "12345", "12345g"]) expect(linear(bad)).toEqual(linear("808080"));
	});

	it("come back from OKLCh as they were", () => {
		fc.assert(
			fc.property(hex, (colour) => {
				const [before, after] = [linear(colour), fromLch(toLch(linear(colour)))];
				for (let k = 0; k < 3; k++) expect(after[k]).toBeCloseTo(before[k], 5);
			}),
		);
		expect(toLch([1, 1, 1])).toMatchObject({ lightness: expect.closeTo(1, 5), chroma: expect.closeTo(0, 4) });
		expect(fromLch({ lightness: 0.7, chroma: 0.4, hue: 0.5 }).every((value) => value >= 0 && value <= 1)).toBe(true);
	});

	it("mix and average channel by channel", () => {
		expect(mixed([0, 0.5, 1], [1, 0.5, 0], 0.25)).toEqual([0.25, 0.5, 0.75]);
		expect(meanColour(Float32Array.from([0, 0.5, 1, 1, 0.5, 0.5]))).toEqual([0.5, 0.5, 0.75]);
	});
});
