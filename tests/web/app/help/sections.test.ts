import { existsSync } from "node:fs";
import { beforeAll, describe, expect, it, vi } from "vitest";
import { FAMILIES } from "../../../../web/src/app/help/pictures";
import { docsLinks, SECTIONS, sectionTitle } from "../../../../web/src/app/help/sections";
import { firstOf } from "../../../../web/src/app/home/families";
import { sectionEntries } from "../../../../web/src/app/palette/help_entries";
import { HELP } from "../../../../web/src/app/parts/late_parts";
import { openPart } from "../../../../web/src/app/parts/open_part";
import type { Studio } from "../../../../web/src/app/studio";
import { modelNames } from "../../../../web/src/models/index";
import { specimenFromPreset } from "../../bunch";
import { studioWith } from "../context";

vi.mock("../../../../web/src/app/parts/open_part", () => ({ openPart: vi.fn() }));

describe("the sections of the help", () => {
	it("have titles of their own", () => {
		expect(new Set(SECTIONS.map(sectionTitle)).size).toBe(SECTIONS.length);
	});

	it("link to pages of the documentation that exist, for every model", () => {
		const addresses = modelNames().flatMap((model) =>
			SECTIONS.flatMap((section) => docsLinks(section, model).map(({ address }) => address)),
		);
		const missing = addresses.filter((address) => {
			const page = address === "docs/" ? "docs/index.md" : address.replace(/\.html$/, ".md");
			return !existsSync(page);
		});
		expect(addresses).toContain("docs/models/stand/parameters.html");
		expect(missing).toEqual([]);
	});

	it("show pictures that the gallery has, in both themes", () => {
		const plants = Object.values(FAMILIES).flatMap((families) => families.map(firstOf));
		const files = plants.flatMap(({ model, preset }) =>
			["light", "dark"].map((theme) => `public/gallery/${model}/${preset}-${theme}.webp`),
		);
		expect(files.length).toBeGreaterThan(4);
		expect(files.filter((file) => !existsSync(file))).toEqual([]);
	});
});

describe("the sections in the command palette", () => {
	let studio: Studio;
	beforeAll(async () => {
		({ studio } = await studioWith(specimenFromPreset()));
	});

	it("are entries that open the help at the section", async () => {
		const entries = await sectionEntries(studio);
		expect(entries.map(({ key }) => key)).toEqual(SECTIONS.map((section) => `help:${section}`));
		entries.find(({ title }) => title === "Help: Growth and time")?.run();
		expect(openPart).toHaveBeenLastCalledWith(studio, HELP, expect.any(Function));
		const help = { open: vi.fn() };
		const [, , use] = vi.mocked(openPart).mock.lastCall as unknown as [unknown, unknown, (element: object) => void];
		use(help);
		expect(help.open).toHaveBeenCalledWith("growth");
	});
});
