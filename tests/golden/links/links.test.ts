/**
 * Published links. Where a frozen link fails, old links have changed: the change needs a new version of links. Links of previews may
 * change: they only have to work. `npm run generate -- links` adds new links to the frozen ones.
 */
import { describe, expect, it } from "vitest";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import { decodeLink } from "../../../web/src/specimen/link";
import { SPECIMEN_VERSION } from "../../../web/src/specimen/specimen";
import { isLongRun } from "../../long_run.mjs";
import { presetLinks } from "./covering_links";
import { growthInput } from "./growth_input";
import { isFrozen, linksToFreeze, meantBy, modelOf, previewLinks, readFrozenLinks, versionOf } from "./list";

const models = await Promise.all(modelNames().map(modelNamed));
const frozen = readFrozenLinks();

describe("frozen links", () => {
	it("are read without a note and grow the recorded plants", async () => {
		const now = await Promise.all(
			frozen.map(async ({ link }) => {
				const { notes, fingerprint } = await meantBy(link);
				expect([link, notes, isFrozen(await modelOf(link), versionOf(link))]).toEqual([link, [], true]);
				return { link, fingerprint };
			}),
		);
		expect(now).toEqual(frozen);
	});

	it("are each listed once, and use every preset, key and detail of the models that are no previews", async () => {
		const links = frozen.map(({ link }) => link);
		expect(new Set(links).size).toBe(links.length);
		expect(links).toEqual(expect.arrayContaining(await linksToFreeze()));
	});

	it("have different fingerprints wherever their plants grow from different values", async () => {
		const first = new Map<string, { link: string; input: unknown }>();
		for (const { link, fingerprint } of frozen) {
			const model = await modelOf(link);
			const input = await growthInput(model, link);
			const key = `${model.name} ${fingerprint}`;
			const known = first.get(key);
			if (known) expect({ ...known, same: link }).toEqual({ ...known, same: link, input });
			else first.set(key, { link, input });
		}
	});
});

describe("links of previews", () => {
	/** `npm test` takes two presets of each model, `npm run test:long` every preset and key. */
	const chosen = async () =>
		isLongRun
			? await previewLinks()
			: models.filter(({ preview }) => preview).flatMap((model) => presetLinks(model, SPECIMEN_VERSION).slice(0, 2));

	it("are read without a note and grow, each preset another plant", async () => {
		const presets = new Map<string, string>();
		for (const link of await chosen()) {
			const { notes, fingerprint } = await meantBy(link);
			expect([link, notes]).toEqual([link, []]);
			expect(fingerprint, link).toMatch(/^[0-9a-f]{16}$/);
			if (!/[?&]preset=/.test(link)) continue;
			expect(presets.get(fingerprint), link).toBeUndefined();
			presets.set(fingerprint, link);
		}
	});
});

describe("a link of a newer version", () => {
	it.each(models.map((model) => ({ model, of: model.name })))(
		"is read as far as it is known: $of",
		async ({ model }) => {
			const link = `?v=${SPECIMEN_VERSION + 1}&model=${model.name}&seed=7&unheard=of`;
			const { specimen, notes } = await decodeLink(model, link);
			expect(specimen).toMatchObject({ model: model.name, seed: 7, v: SPECIMEN_VERSION });
			expect(notes.map(({ text }) => text)).toEqual([
				expect.stringContaining(`v: The plant was made with a newer version (${SPECIMEN_VERSION + 1}).`),
				expect.stringMatching(/^unheard: There is no such parameter/),
			]);
		},
	);
});
