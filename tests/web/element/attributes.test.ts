import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { isSpecimenAttribute, OWN_ATTRIBUTES, readAttributes } from "../../../web/src/element/attributes";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { encodeLink } from "../../../web/src/specimen/link";
import { isKnown } from "../../../web/src/specimen/restore";
import { inRun } from "../../long_run.mjs";

const read = (values: Record<string, string>) =>
	readAttributes(Object.entries(values).map(([name, value]) => ({ name, value })));
const textsOf = ({ notes }: Awaited<ReturnType<typeof read>>) => notes.map(({ text }) => text);

describe("the specimen in attributes", () => {
	it("is the default without attributes", async () => {
		const model = await modelNamed();
		expect(await read({})).toEqual({ model, specimen: fromPreset(model), notes: [] });
	});

	it("is a preset of the named model, with changed parameters", async () => {
		const { model, specimen, notes } = await read({ model: "leaf", preset: "oak", seed: "7", length: "90" });
		expect(notes).toEqual([]);
		expect([model.name, specimen]).toMatchObject(["leaf", { preset: "oak", seed: 7, parameters: { length: 90 } }]);
	});

	it.each([
		"?v=2&preset=merlot&age=60",
		"https://any.example/plants/?v=2&preset=merlot&age=60#",
		"?preset=merlot&age=60&v=2",
	])("is that of the link %s, changed by other attributes", async (link) => {
		const { specimen, notes } = await read({ link, seed: "3" });
		expect(notes).toEqual([]);
		expect(specimen).toMatchObject({ preset: "merlot", seed: 3, parameters: { age: 60 } });
	});

	it("has the link’s model and the text in its fragment", async () => {
		expect((await read({ link: "?v=2&model=root&preset=carrot" })).model.name).toBe("root");
		const bunch = await modelNamed();
		const own = { ...fromPreset(bunch), grammar: "axiom: F(0.1)\n" };
		expect((await read({ link: await encodeLink(bunch, own as never) })).specimen).toEqual(own);
	});

	it("has notes about attributes that cannot be used", async () => {
		expect(textsOf(await read({ preset: "nettle" }))).toEqual([expect.stringMatching(/^preset: .*nettle/)]);
		expect(textsOf(await read({ age: "900" }))).toEqual(["age: 900 is above the maximum, 125. Using 125."]);
		expect(textsOf(await read({ model: "fern" }))).toEqual([
			"model: There is no model “fern”. The default model is used.",
		]);
		expect(textsOf(await read({ colour: "red" }))).toEqual([
			"colour: The model bunch has no such parameter. The attribute was ignored.",
		]);
	});

	it("is not changed by global attributes, those of frameworks, or the element’s own", async () => {
		const others = [
			"class",
			"style",
			"id",
			"aria-busy",
			"data-x",
			"_ngcontent-c1",
			"onclick",
			"v-on:x",
			...OWN_ATTRIBUTES,
		];
		expect(others.filter(isSpecimenAttribute)).toEqual([]);
		expect((await read(Object.fromEntries(others.map((name) => [name, "x"])))).notes).toEqual([]);
	});

	it("can set every parameter of every model by an attribute", async () => {
		for (const model of await Promise.all(modelNames().map(modelNamed))) {
			const keys = [...model.table.links.keys()];
			expect(keys.filter((key) => !isSpecimenAttribute(key) || key !== key.toLowerCase())).toEqual([]);
			expect(OWN_ATTRIBUTES.filter((key) => isKnown(model, key))).toEqual([]);
		}
	});

	it("is valid for any attributes", () =>
		fc.assert(
			fc.asyncProperty(
				fc.dictionary(fc.constantFrom("link", "model", "preset", "seed", "age", "thin", "x"), fc.string()),
				async (values) => {
					const { model, specimen } = await read(values);
					expect(specimen.model).toBe(model.name);
					expect(model.presets.named(specimen.preset)).toBeDefined();
				},
			),
			{ numRuns: inRun(60, 200) },
		));
});
