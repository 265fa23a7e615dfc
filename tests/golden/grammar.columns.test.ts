/**
 * Goldens of what texts grow: every column of every text, natively and as wasm. Links hold to segments and organs alone
 * (links/links.json); what is drawn may change where it becomes better (`UPDATE_GOLDENS=1 npx vitest run tests/golden/grammar`).
 */
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, expect, it } from "vitest";
import { loadCoreFromBytes } from "../../web/src/core/loader";
import { model } from "../../web/src/models/grammar/index";
import { PRESETS } from "../../web/src/models/grammar/presets.generated";
import { fetchTexts } from "../../web/src/models/grammar/texts";
import { fromPreset } from "../../web/src/specimen/from_preset";
import { digest } from "./digest";
import { buildNative, grownNatively } from "./growing";

const GOLDENS = new URL("./grammar.columns.json", import.meta.url);
const MODULE = new URL("../../build/core/grammar.wasm", import.meta.url);
/** Of very many modules: they would take as long as all the others. */
const LARGE = new Set(["compound-leaf", "flower-field"]);

await fetchTexts();
// Of presets that share a text one will do.
const subjects = PRESETS.filter(({ name, text }) => name === text && !LARGE.has(name)).map(({ name }) => ({
	name,
	request: model.encode(fromPreset(model, name), { meshFingerprint: true }),
}));

const found: Record<string, Record<string, string>> = {};

beforeAll(async () => {
	const core = await loadCoreFromBytes(readFileSync(MODULE));
	await buildNative();
	for (const { name, request } of subjects) found[name] = digest(core.grow(request).columns);
	if (process.env.UPDATE_GOLDENS) writeFileSync(GOLDENS, `${JSON.stringify(found, null, "\t")}\n`);
}, 300_000);

it("every text is what it was, column by column", () => {
	expect(found).toEqual(JSON.parse(readFileSync(GOLDENS, "utf8")));
});

it("native and wasm agree in every column", { timeout: 300_000 }, () => {
	for (const { name, request } of subjects) expect(digest(grownNatively(request)), name).toEqual(found[name]);
});
