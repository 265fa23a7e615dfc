import { beforeAll, describe, expect, it } from "vitest";
import { placeInWords, searchPresets } from "../../../web/src/app/preset_search";
import { kindKey, type PresetSection, sectionsOf } from "../../../web/src/app/preset_sections";
import synonyms from "../../../web/src/app/search/synonyms.json";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import type { PageModel } from "../../../web/src/models/page_model";
import { toy } from "../toy";
import { bunchModel } from "./context";

const sections = sectionsOf([bunchModel, toy as unknown as PageModel]);
const found = (query: string) => searchPresets(sections, query).map(({ entry }) => entry.preset.name);

describe("the gallery's sections", () => {
	it("are every model's kinds, in order, with all their presets", () => {
		const bunch = ["shape", "variety", "fruit", "figure"].map((kind) => `bunch ${kind}`);
		expect(sections.map(kindKey)).toEqual([...bunch, "toy bare", "toy flown"]);
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
		["wing BLUE somewhat", ["merlot"]],
		["plum pudding", []],
	])("for %j finds %j", (query, names) => expect(found(query)).toEqual(names));

	it("searches kinds and models, too", () => {
		expect(found("flagpole").sort()).toEqual(["märz", "plain"]);
		expect(found("other fruits")).toEqual(["redcurrant", "rubus", "lychee", "longan", "duku"]);
	});

	it("indexes parts of the sections by themselves", () => {
		const flown = sections.filter(({ kind }) => kind.key === "flown");
		expect(searchPresets(flown, "flagpole").map(({ entry }) => entry.preset.name)).toEqual(["märz"]);
		expect(searchPresets(flown, "plain")).toEqual([]);
	});
});

describe("a search of all models' presets", () => {
	let all: readonly PresetSection[];
	beforeAll(async () => {
		all = sectionsOf(await Promise.all(modelNames().map((name) => modelNamed(name))));
	});
	const names = (query: string) =>
		searchPresets(all, query).map(({ entry: { model, preset } }) => `${model.name}/${preset.name}`);
	const levelOf = (query: string, name: string) =>
		Math.floor((searchPresets(all, query).find(({ entry }) => entry.preset.name === name)?.score ?? Number.NaN) / 10);

	it("finds every preset first by its own title", () => {
		const misplaced = all.flatMap(({ presets }) =>
			presets
				.map(({ title }) => [title, searchPresets(all, title)[0]?.entry.preset.title])
				.filter(([title, first]) => first !== title),
		);
		expect(misplaced).toEqual([]);
		expect(all.flatMap(({ presets }) => presets).length).toBeGreaterThan(200);
	});

	it("tells presets with equal titles apart by the line below the title", () => {
		const lines = all.flatMap((section) =>
			section.presets.map((preset) => `${preset.title}: ${placeInWords({ ...section, preset })}`),
		);
		expect(lines.filter((line, i) => lines.indexOf(line) !== i)).toEqual([]);
		expect(lines).toContain("Oak: Trees · Species · Growth grammars");
		expect(lines).toContain("Oak: Trees · Particle systems");
		expect(lines).toContain("Long conical: Grapes · Shapes · Fig. 11");
	});

	it.each([
		["stands", "stand/vineyard"],
		["lsystem", "grammar/parametric-example"],
		["l-systems", "grammar/borchert-slade"],
		["conifer", "growth/spruce"],
		["wine", "stand/vineyard"],
		["forest", "stand/forest-edge"],
		["wood", "stand/forest-edge"],
		["flower bed", "stand/flowerbed"],
		["hedges", "tree/hedge"],
		["bonsais", "tree/bonsai"],
		["orchards", "stand/orchard"],
		["roses", "flower/rose"],
		["fractals", "grammar/dragon-curve"],
		["koch", "grammar/koch-curve-a"],
		["trees", "growth/oak"],
		["oak tree", "tree/oak"],
		["the oak", "growth/oak"],
		["cherries", "growth/cherry"],
		["grapes", "bunch/pinot-noir"],
		["leaves", "leaf/grapevine"],
		["stonepine", "growth/stone-pine"],
		["stone pi", "growth/stone-pine"],
		["un chêne", "growth/oak"],
		["bouleaux", "growth/birch"],
		["feuilles", "leaf/grapevine"],
		["Vignes", "stand/vineyard"],
		["15(a)", "bunch/grape-15a"],
		["1.24 b", "grammar/plant-b"],
	])("finds %j: first %s", (query, first) => expect(names(query)[0]).toBe(first));

	it.each([
		["tulp", "flower/tulip"],
		["rsoe", "flower/rose"],
		["vinyard", "stand/vineyard"],
		["sunflowwer", "flower/sunflower"],
		["cheries", "growth/cherry"],
		["confier", "growth/spruce"],
		["conif", "growth/spruce"],
		["gewruz", "bunch/gewurztraminer"],
	])("forgives the typo or the missing end of %j: first %s", (query, first) => expect(names(query)[0]).toBe(first));

	it("takes no typo where a word is found, in short words, in numbers or twice in a word", () => {
		expect(names("pine")).not.toContain("stand/vineyard");
		expect(names("oka")).toEqual([]);
		expect(names("fig 111")).toEqual([]);
		expect(names("tlp")).toEqual([]);
		expect(names("tuilpp")).toEqual([]);
	});

	it.each(["fig 11", "figure 11", "fig. 11", "Fig.11", "FIGURES 11", "figure 11 of the paper"])(
		"finds figure 11 alone for %j",
		(query) => expect(names(query)).toEqual(["bunch/long-conical"]),
	);

	it("finds the parts of a figure and the rows of a table, but no number that begins alike", () => {
		expect(names("fig 15").sort()).toEqual(["a", "b", "c", "d"].map((part) => `bunch/grape-15${part}`));
		expect(names("fig. 15 c")).toEqual(["bunch/grape-15c"]);
		expect(names("figure 1")).toEqual(["grammar/topiary-garden-tree"]);
		expect(names("table 1").slice(0, 6).sort()[0]).toMatch(/^growth\/table-1-/);
		expect(names("table 3")[0]).toBe("flower/table-3");
	});

	it("lists titles before families and shelves, and those before descriptions", () => {
		const levels = searchPresets(all, "pine").map(({ score }) => Math.floor(score / 10));
		expect(levels).toEqual([...levels].sort((a, b) => a - b));
		expect(levelOf("sunflo", "sunflowers")).toBe(0);
		expect(levelOf("species spruce", "spruce")).toBe(1);
		expect(levelOf("wine", "riesling")).toBe(1);
		expect(levelOf("freckled", "riesling")).toBe(2);
	});

	it("has no synonym that leads nowhere", () => {
		const without = Object.keys(synonyms).filter((phrase) => names(phrase).length === 0);
		expect(without).toEqual([]);
		const dead = Object.entries(synonyms).flatMap(([phrase, others]) =>
			others.filter((other) => !other.includes(":") && names(other).length === 0).map((other) => [phrase, other]),
		);
		expect(dead).toEqual([]);
	});
});
