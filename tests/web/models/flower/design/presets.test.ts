import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { isEdited } from "../../../../../web/src/models/flower/design/choose";
import { assembled, designOf } from "../../../../../web/src/models/flower/design/design";

const folder = "wasm-core/grammars/flower";
const texts = readdirSync(folder)
	.filter((file) => file.startsWith("designed-"))
	.map((file) => ({ file, text: readFileSync(join(folder, file), "utf8") }));

describe("the designed flowers of the shelf", () => {
	it("are as many as they were", () => {
		expect(texts.length).toBeGreaterThanOrEqual(4);
	});

	it.each(texts)("has $file as its descriptions make it (UPDATE_GOLDENS=1 makes it anew)", ({ file, text }) => {
		const design = designOf(text);
		if (!design) throw new Error("no design");
		const descriptions = design.sections.map(({ description }) => description);
		if (process.env.UPDATE_GOLDENS) writeFileSync(join(folder, file), assembled(descriptions, design.head));
		else expect(design.sections.filter(isEdited).map(({ description }) => description.organ)).toEqual([]);
	});
});
