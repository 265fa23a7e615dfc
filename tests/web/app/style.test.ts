import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";

/** Folders with style sheets. */
const FOLDERS = ["web/src/app/style", "web/src/grammar_editor"];

/** Declarations that do not mirror in scripts from right to left. */
const PHYSICAL =
	/^\s*((?:margin|padding|border)-(?:left|right)|left|right|(?:text-align|float): (?:left|right))\b(?!: 50%)/;

const physicalLines = (css: string): string[] => css.split("\n").filter((line) => PHYSICAL.test(line));

describe("style sheets", () => {
	it("use logical properties, which follow the direction of the script", () => {
		const sheets = FOLDERS.flatMap((folder) =>
			readdirSync(folder)
				.filter((name) => name.endsWith(".css"))
				.map((name) => join(folder, name)),
		);
		expect(sheets.length).toBeGreaterThan(20);
		const found = sheets.flatMap((file) => physicalLines(readFileSync(file, "utf8")).map((line) => `${file}: ${line}`));
		expect(found).toEqual([]);
	});

	it("are searched for physical properties, except centred ones", () => {
		expect(physicalLines("\tmargin-left: 2px;\n\tleft: 0;\n\ttext-align: right;\n\tleft: 50%;")).toHaveLength(3);
		expect(physicalLines("\tinset-inline-start: 0;\n\ttext-align: start;\n\t--left: 1;")).toEqual([]);
	});
});
