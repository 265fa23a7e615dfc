/** Recognition of flowers' texts that come without a model's name. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { FLOWER } from "../../../../web/src/models/flower/schema";
import { xmlOf } from "../../../../web/src/models/flower/xml/write";
import { readText } from "../../../../web/src/models/for_text";

const claims = (text: string): boolean => FLOWER.details.some((detail) => detail.claims?.(text));

const folder = "wasm-core/grammars";
const shelf = readdirSync(folder).flatMap((model) =>
	readdirSync(join(folder, model))
		.filter((file) => !file.endsWith(".json"))
		.map((file) => [file, readFileSync(join(folder, model, file), "utf8")] as const),
);

const FLOWERS = {
	"of blanks behind its signs": "# define A(4,0,0,0,1,1,1,1)\n # axiom: A\nA -> A[A]_{E}",
	"of modules alone": "#define A\n# module M\n#axiome: A",
	"that only halves": "#define A\n#define B\n#define C\n#axiom: A\nA -E-> B C",
	"that only halves, with an arrow": "#define A\n#axiom: A\nA - C1 \u2192 A A",
	"whose only face is misspelt": "#define A\n#axiom: A\nA -> A[A]_{c1}",
	"without a production": "#define A(4,0,0,0,1,1,1,1)\n#axiom: A",
	"whose numbers are names, but for one": "#define A( sides, 0,angle,0,long,wide,wide,m)\n#axiom: A",
	"whose numbers have signs": "#define A(n,< -3 >)\n#axiom: A",
};

describe("a text without a name", () => {
	it.each(shelf)("that is %s is a flower's where that is its ending", (file, text) => {
		expect(claims(text)).toBe(file.endsWith(".gl3"));
	});

	it.each(Object.entries(FLOWERS))("%s is a flower's, and so is its XML", async (_, text) => {
		expect(claims(text)).toBe(true);
		const read = await readText(xmlOf(text));
		expect(read.model?.name).toBe("flower");
		expect(claims(read.text)).toBe(true);
	});

	it("is not a flower's without an axiom or without a flower's own statements", () => {
		expect(claims("#define A(4,0,0,0,1,1,1,1)\naxiom: A\nA --> A[A]_{E}")).toBe(false);
		expect(claims("#define STEP(x) x*2\n#define r 0.5\n#axiom: A\nA --> F[+A]F")).toBe(false);
	});

	it("is known in a time that grows with its length alone", () => {
		const blanks = " ".repeat(100_000);
		for (const text of [
			`]${blanks}`,
			`-${blanks}`,
			`#define${blanks}A${blanks}(${blanks}`,
			`#define A(${"-".repeat(100_000)}`,
			`#define A(${", ".repeat(50_000)}`,
			`#define A(${blanks},${blanks}<${blanks}`,
			`#define ${"a".repeat(100_000)}`,
			`#${blanks}`.repeat(2),
		])
			expect(claims(`#axiom: A\n${text}`)).toBe(false);
	});
});
