import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { shortFloat } from "../../../web/src/formats/numbers";
import { TextBuffer } from "../../../web/src/formats/text_buffer";
import { inRun } from "../../long_run.mjs";

const SPACE = 0x20;

const written = (write: (out: TextBuffer) => void) => {
	const out = new TextBuffer(1);
	write(out);
	return out.toString();
};

describe("the text buffer", () => {
	it("writes the nearest decimal without zeros at its end", () => {
		const cases: [number, number, string][] = [
			[0, 6, "0"],
			[-0, 6, "0"],
			[1, 6, "1"],
			[-12.5, 3, "-12.5"],
			[0.000001, 6, "0.000001"],
			[0.0000004, 6, "0"],
			[-0.0000004, 6, "0"],
			[0.1000004, 6, "0.1"],
			[10.05, 2, "10.05"],
			[1234.5678, 0, "1235"],
			[5000, 6, "5000"],
		];
		for (const [value, decimals, text] of cases)
			expect(written((out) => out.fixed(value, decimals, SPACE))).toBe(`${text} `);
	});

	it("is within half a step of any number, and as short as can be", () => {
		fc.assert(
			fc.property(
				fc.double({ min: -1e4, max: 1e4, noNaN: true }),
				fc.integer({ min: 0, max: 6 }),
				(value, decimals) => {
					const text = written((out) => out.fixed(value, decimals, SPACE)).slice(0, -1);
					expect(Math.abs(Number(text) - value)).toBeLessThanOrEqual(0.5 * 10 ** -decimals + 1e-11);
					expect(text).toMatch(/^-?(0|[1-9]\d*)(\.\d*[1-9])?$/);
					expect(text).not.toBe("-0");
				},
			),
		);
	});

	it("writes a float32 as JSON has it", () => {
		const value = fc.oneof(
			fc.float(),
			fc.float({ min: -1, max: 1, noDefaultInfinity: true, noNaN: true }),
			fc.integer({ min: -2000, max: 2000 }).map((thousandths) => Math.fround(thousandths / 1000)),
			fc.integer(),
			fc.maxSafeInteger().map(Math.fround),
		);
		fc.assert(
			fc.property(value, (value) => {
				expect(written((out) => out.short(value))).toBe(JSON.stringify(shortFloat(value)));
			}),
			{
				numRuns: inRun(500, 2000),
				examples: [[-0], [1e-6], [Math.fround(1e-6)], [Math.fround(9.9999e-7)], [1e9], [1e21], [0.5]].map(
					([each]) => [each] as [number],
				),
			},
		);
	});

	it("gives what was appended as bytes of its own", () => {
		const out = new TextBuffer();
		out.word("a“b");
		const bytes = out.bytes();
		out.word("c");
		expect(bytes).toEqual(new TextEncoder().encode("a“b"));
	});

	it("writes whole numbers and any text, growing as it must", () => {
		fc.assert(
			fc.property(
				fc.array(fc.oneof(fc.integer({ min: 0, max: 0x7fffffff }), fc.string({ unit: "grapheme" }))),
				(parts) => {
					const text = written((out) => {
						for (const part of parts) typeof part === "number" ? out.integer(part, SPACE) : out.text(part);
					});
					expect(text).toBe(
						new TextDecoder().decode(
							new TextEncoder().encode(parts.map((part) => (typeof part === "number" ? `${part} ` : part)).join("")),
						),
					);
				},
			),
		);
	});
});
