/** Every example of the language grows without a note and matches its description. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { beforeAll, describe, expect, it } from "vitest";
import { repository } from "../../wasm-core/tools/repository.mjs";
import type { Core } from "../../web/src/core/core";
import { model } from "../../web/src/models/grammar/index";
import { fetchTexts } from "../../web/src/models/grammar/texts";
import { fromPreset } from "../../web/src/specimen/from_preset";
import { freshCore } from "../web/core/wasm";

const page = ["docs/language.md", "docs/models/grammar/grammar.md", "docs/quick-start.md"]
	.map((file) => readFileSync(join(repository, file), "utf8"))
	.join("\n");
const examples = [...page.matchAll(/^```lsys\n([\s\S]*?)^```$/gm)].map((found) => found[1] as string);

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("grammar.wasm");
});

describe("docs/language.md, the model's page and the quick start", () => {
	it("has an example for each section that needs one", () => expect(examples.length).toBeGreaterThanOrEqual(6));

	it.each(examples.map((text) => [text.trim().split("\n")[0], text]))("grows %s", (_, text) => {
		const plant = model.read(core.grow(model.encode({ ...fromPreset(model), grammar: text as string })));
		expect(plant.notes).toEqual([]);
		expect(plant.counts.segments + plant.counts.organs).toBeGreaterThan(1);
	});
});
