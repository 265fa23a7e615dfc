import { describe, expect, it } from "vitest";
import { argumentsOf, readMessage } from "../../wasm-core/tools/generate/icu.mjs";

describe("readMessage", () => {
	it("reads text, names, plurals with # and nested cases", () => {
		expect(
			readMessage("Line {line}: {count, plural, =0 {nothing} one {# berry} other {# berries of {name}}}."),
		).toEqual([
			"Line ",
			{ name: "line" },
			": ",
			{
				name: "count",
				kind: "plural",
				cases: {
					"=0": ["nothing"],
					one: [{ number: "count" }, " berry"],
					other: [{ number: "count" }, " berries of ", { name: "name" }],
				},
			},
			".",
		]);
	});

	it.each(["{", "{name", "}", "{Name}", "{n, date}", "{n, plural, one {a}}", "{n, plural, other {a}"])(
		"returns an error with the column for %s",
		(message) => {
			expect(() => readMessage(message)).toThrow(/^column \d+: /);
		},
	);

	it("lists arguments in the order of first use, counted ones as numbers", () => {
		const found = argumentsOf(readMessage("{a} {b, plural, one {{c}} other {#}} {a}"));
		expect([...found]).toEqual([
			["a", "text"],
			["b", "number"],
			["c", "text"],
		]);
	});
});
