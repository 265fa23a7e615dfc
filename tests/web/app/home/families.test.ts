import { describe, expect, it } from "vitest";
import { namesPlant } from "../../../../web/src/app/address_plant";
import { families, queryOf } from "../../../../web/src/app/home/families";
import { familyOf } from "../../../../web/src/app/preset_cards";
import { modelNamed, modelNames } from "../../../../web/src/models/index";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { decodeQuery } from "../../../../web/src/specimen/link";
import { FAMILIES } from "../../../../web/src/specimen/presets";

describe("families of plants", () => {
	it("are in the same order as in the gallery, each with a title and a description", () => {
		expect(families().map(({ key }) => key)).toEqual(FAMILIES);
		for (const { title, about } of families()) expect([title, about].every((text) => text.length > 4)).toBe(true);
	});

	it("open with a preset that belongs to the family, by a link that is read without a note", async () => {
		for (const { key, model: name, preset } of families()) {
			const model = await modelNamed(name);
			expect(model.presets.named(preset), key).toBeDefined();
			const { specimen, notes } = decodeQuery(model, queryOf(name, preset));
			expect(notes).toEqual([]);
			expect(specimen).toEqual(fromPreset(model, preset));
			expect(familyOf(model, specimen)).toBe(key);
		}
	});

	it("are those of all kinds of presets", async () => {
		for (const name of modelNames()) {
			const { presets } = await modelNamed(name);
			for (const { family } of presets.kinds) expect(FAMILIES).toContain(family);
		}
	});
});

describe("an address", () => {
	const address = (search: string, hash = "") => namesPlant({ search, hash });

	it("names a plant by any key of a link, or by a fragment", () => {
		for (const search of ["?v=2", "?preset=duku", "?model=leaf&utm_source=x", "?l=200"])
			expect(address(search)).toBe(true);
		expect(address("", "#g=abc")).toBe(true);
	});

	it("names none without a query, or with keys that other sites add", () => {
		for (const search of ["", "?", "?utm_source=news&fbclid=1"]) expect(address(search)).toBe(false);
	});
});
