import { afterEach, describe, expect, it } from "vitest";
import { preferredLanguage, useLanguage } from "../../../web/src/locale/locale";
import { translatedPresets, translatedTable } from "../../../web/src/specimen/translated_tables";

const size = {
	key: "size",
	link: "s",
	label: "Size",
	symbol: "",
	group: "shape",
	unit: "mm",
	help: "The width.",
	since: 1,
};
const range = { kind: "number", min: 0, max: 9, default: 0, step: 1 } as const;
const fruit = {
	...size,
	...range,
	key: "fruit",
	link: "f",
	kind: "choice",
	options: ["grape", "red_currant"],
} as const;
const groups = [{ key: "shape", title: "Shape", help: "The outline." }];
const length = {
	key: "length",
	label: "Length",
	group: "shape",
	kind: "note",
	unit: "",
	decimals: 0,
	help: "How long.",
} as const;
const classes = [{ note: 1, words: "short", from: 0 }];

const build = () =>
	translatedTable("toy", [{ ...size, ...range, zero: "auto" }, fruit], groups, [{ ...length, classes }], []);

async function inFrench(entries: Readonly<Record<string, string>>): Promise<void> {
	const language = { key: "fr", tag: "fr-FR", name: "Français", direction: "ltr" } as const;
	await useLanguage({ ...language, load: async () => (code) => entries[code] });
}

afterEach(() => useLanguage(preferredLanguage([])));

describe("translatedTable", () => {
	it("keeps English without a translation, with options in words", () => {
		const table = build();
		expect(table.entry("size")).toMatchObject({ label: "Size", help: "The width.", zero: "auto" });
		expect(table.entry("fruit")).toMatchObject({ options: ["grape", "red_currant"], labels: ["Grape", "Red currant"] });
	});

	it("translates labels, help, options, groups, measures and their classes, but no key", async () => {
		await inFrench({
			"parameters.toy.size_label": "Taille",
			"parameters.toy.size_zero": "automatique",
			"parameters.toy.fruit_option_red_currant": "Groseille",
			"parameters.toy.group_shape_title": "Forme",
			"measures.toy.length_label": "Longueur",
			"measures.toy.length_class_1": "court",
		});
		const table = build();
		expect(table.entry("size")).toMatchObject({
			key: "size",
			label: "Taille",
			help: "The width.",
			zero: "automatique",
		});
		expect(table.entry("fruit")).toMatchObject({ options: fruit.options, labels: ["Grape", "Groseille"] });
		expect(table.groups).toEqual([{ key: "shape", title: "Forme", help: "The outline." }]);
		expect(table.measures[0]).toMatchObject({ label: "Longueur", classes: [{ note: 1, words: "court", from: 0 }] });
	});
});

describe("translatedPresets", () => {
	it("translates titles, descriptions and kinds, but no name", async () => {
		await inFrench({
			"presets.toy.a-1_title": "Un",
			"presets.toy.a-1_about": "Le premier.",
			"presets.toy.kind_k_title": "Tous",
		});
		const preset = { name: "a-1", kind: "k", title: "One", about: "The first.", parameters: {}, look: {} };
		const presets = translatedPresets("toy", [preset], [{ key: "k", title: "All", family: "trees" }], "a-1");
		expect(presets.named("a-1")).toEqual({ ...preset, title: "Un", about: "Le premier." });
		expect(presets.kinds).toEqual([{ key: "k", title: "Tous", family: "trees" }]);
	});
});
