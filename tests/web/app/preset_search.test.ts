import { describe, expect, it } from "vitest";
import { findPresets, kindKey, sectionsOf } from "../../../web/src/app/preset_search";
import type { PageModel } from "../../../web/src/models/page_model";
import { toy } from "../toy";
import { bunchModel } from "./context";

const sections = sectionsOf([bunchModel, toy as unknown as PageModel]);
const found = (query: string, kind?: string) =>
	findPresets(sections, query, kind).flatMap(({ presets }) => presets.map(({ name }) => name));

describe("the gallery's sections", () => {
	it("are every model's kinds, in order, with all their presets", () => {
		expect(sections.map(kindKey)).toEqual(["bunch shape", "bunch variety", "bunch fruit", "toy bare", "toy flown"]);
		const all = [...bunchModel.presets.list, ...toy.presets.list].map(({ name }) => name);
		expect(found("").sort()).toEqual(all.sort());
	});

	it("leave out kinds without presets", () => {
		const kinds = [...toy.presets.kinds, { key: "lost", title: "Lost" }];
		const model = { ...toy, presets: { ...toy.presets, list: toy.presets.list, kinds } } as unknown as PageModel;
		expect(sectionsOf([model]).map(({ kind }) => kind.key)).toEqual(["bare", "flown"]);
	});
});

describe("a search", () => {
	it.each([
		["gewurz", ["gewurztraminer"]],
		["GEWÜRZ", ["gewurztraminer"]],
		["marz", ["märz"]],
		["blue-black wing", ["cabernet-sauvignon", "merlot"]],
		["somewhat-loose wing", []],
		["wing BLUE somewhat", ["merlot"]],
		["plum pudding", []],
	])("for %j finds %j", (query, names) => expect(found(query)).toEqual(names));

	it("searches kinds and models, too", () => {
		expect(found("flagpole")).toEqual(["plain", "märz"]);
		expect(found("other fruits")).toEqual(["redcurrant", "rubus", "lychee", "longan", "duku"]);
	});

	it("is limited to the chosen kind", () => {
		expect(found("", "toy flown")).toEqual(["märz"]);
		expect(found("plain", "toy flown")).toEqual([]);
		expect(found("cone", "bunch shape")).toContain("long-conical");
		expect(found("cone", "bunch fruit")).toEqual([]);
	});
});
