/**
 * Links of every version and model still give the plants that they gave. Where one of `frozen` fails, old links have changed: make a new
 * version. `npm run generate -- links` lists new ones, `npm run generate -- links --renew` takes what previews mean now.
 */
import { describe, expect, it } from "vitest";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import { decodeLink } from "../../../web/src/specimen/link";
import { SPECIMEN_VERSION } from "../../../web/src/specimen/specimen";
import { FROZEN_VERSION, isFrozen, type Listed, meantBy, modelOf, readList, versionOf } from "./list";
import { standingLinks } from "./standing_links";

const list = readList();
const models = await Promise.all(modelNames().map(modelNamed));
const listed = [...list.frozen, ...list.previews];
const linksOf = (links: readonly Listed[]) => links.map(({ link }) => link);

describe("published links", () => {
	it.each([
		["that are frozen give the same plants for ever", list.frozen, true],
		["of previews give the plants that they gave last; that may change", list.previews, false],
	])("%s", async (_, links, frozen) => {
		const now = await Promise.all(
			links.map(async ({ link }) => {
				const { notes, fingerprint } = await meantBy(link);
				expect([link, notes, isFrozen(await modelOf(link), versionOf(link))]).toEqual([link, [], frozen]);
				return { link, fingerprint };
			}),
		);
		expect(now).toEqual(links);
	});

	it("are each in the list once, of every model and version that there is", () => {
		expect(new Set(linksOf(listed)).size).toBe(listed.length);
		const missing = models.flatMap((model) => {
			const versions = model.preview ? [SPECIMEN_VERSION] : Array.from({ length: FROZEN_VERSION }, (_, i) => i + 1);
			return versions.flatMap((version) => standingLinks(model, version));
		});
		expect(linksOf(listed)).toEqual(expect.arrayContaining(missing));
	});

	it("differ in what they grow into, but for looks and what a preset has as it is", () => {
		expect(new Set(listed.map(({ fingerprint }) => fingerprint)).size).toBeGreaterThan(0.45 * listed.length);
	});
});

describe("a link from a newer version", () => {
	it.each(models.map((model) => ({ model, of: model.name })))("says so: $of", async ({ model }) => {
		const link = `?v=${SPECIMEN_VERSION + 1}&model=${model.name}&seed=7&unheard=of`;
		const { specimen, notes } = await decodeLink(model, link);
		expect(specimen).toMatchObject({ model: model.name, seed: 7, v: SPECIMEN_VERSION });
		expect(notes.map(({ text }) => text)).toEqual([
			`v: made by a newer version (${SPECIMEN_VERSION + 1}); read as far as it is known here.`,
			expect.stringMatching(/^unheard: not known here/),
		]);
	});
});
