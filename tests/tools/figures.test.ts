/** The figures in the pages of documentation are brought up to date by `npm run docs -- figures`. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { withFigures } from "../../wasm-core/tools/figures.mjs";
import { replaceSection } from "../../wasm-core/tools/generate/section.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { pagesWithFigures } from "../sizes/figures.mjs";

const figures = new Map([
	["core", { value: 190_123 }],
	["app", { value: 8_829_492 }],
	["files", { value: 1_234 }],
	["presets", { value: 21, exact: true }],
]);
const figure = (name: string, shown: string) => `<!-- figure: ${name} -->${shown}<!-- /figure -->`;
const updated = (name: string, shown: string) =>
	/-->(.*)<!--/.exec(withFigures(`It has ${figure(name, shown)}.`, figures))?.[1];

describe("withFigures", () => {
	it("keeps a size that differs by at most 2 %, and replaces one that differs by more", () => {
		expect(updated("core", "187 kB")).toBe("187 kB");
		expect(updated("core", "186 kB")).toBe("190 kB");
		expect(updated("core", "200 kB")).toBe("190 kB");
		expect(updated("app", "8.8 MB")).toBe("8.8 MB");
		expect(updated("app", "8.5 MB")).toBe("8.83 MB");
		expect(updated("files", "1,250")).toBe("1,250");
		expect(updated("files", "900")).toBe("1,234");
	});

	it("replaces a count that is not exact", () => {
		expect(updated("presets", "21")).toBe("21");
		expect(updated("presets", "20")).toBe("21");
	});

	it("fills in a figure that is no number, in a unit that suits it", () => {
		expect(updated("core", "?")).toBe("190 kB");
		expect(updated("app", "")).toBe("8.83 MB");
		expect(updated("presets", "?")).toBe("21");
	});

	it("keeps the unit of the page", () => expect(updated("app", "1,000 kB")).toBe("8,830 kB"));

	it("changes every figure of a line and nothing else", () => {
		const page = `# Size\n\n| core | ${figure("core", "1 kB")}, ${figure("presets", "1")} |\n`;
		expect(withFigures(page, figures)).toBe(
			`# Size\n\n| core | ${figure("core", "190 kB")}, ${figure("presets", "21")} |\n`,
		);
	});

	it("keeps a figure that is known but not measured here, and refuses a name that is not known", () => {
		const page = `It has ${figure("offline app", "1 MB")}.`;
		expect(withFigures(page, figures, () => true)).toBe(page);
		expect(() => withFigures(page, figures)).toThrow("There is no figure “offline app”.");
	});

	it("leaves a figure in code as it is", () => {
		const page = "Write `<!-- figure: NAME -->1 kB<!-- /figure -->`.";
		expect(withFigures(page, figures)).toBe(page);
	});

	it("refuses a figure at the beginning of a line, which Markdown takes for HTML", () => {
		expect(() => withFigures(`Size:\n${figure("core", "190 kB")} of wasm`, figures)).toThrow(
			"A line begins with the figure “core”",
		);
	});
});

describe("pages of documentation", () => {
	it("have counts that are up to date", async () => {
		const pages = await pagesWithFigures({ sizes: false });
		expect(pages.length).toBeGreaterThan(2);
		const stale = pages.filter(({ path, text }) => readFileSync(join(repository, path), "utf8") !== text);
		expect(
			stale.map(({ path }) => path),
			"run `npm run docs -- figures`",
		).toEqual([]);
	});
});

describe("replaceSection", () => {
	it("replaces the text between the markers", () => {
		const page = "# A\n\n<!-- t: begin -->\nold\n<!-- t: end -->\n\nB\n";
		expect(replaceSection(page, "t", "new\n")).toBe("# A\n\n<!-- t: begin -->\n\nnew\n\n<!-- t: end -->\n\nB\n");
	});

	it("throws where a marker is missing", () => {
		expect(() => replaceSection("<!-- t: begin -->", "t", "new")).toThrow("lacks <!-- t: begin --> or <!-- t: end -->");
	});
});
