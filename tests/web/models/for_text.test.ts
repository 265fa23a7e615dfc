/** The model of a text that is opened as a file, and the settings that its file has besides the text. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { readText } from "../../../web/src/models/for_text";
import { modelNamed } from "../../../web/src/models/index";
import type { Model } from "../../../web/src/models/model";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { readTextFile, writeTextFile } from "../../../web/src/specimen/text_file";

const folder = "wasm-core/grammars";
const shelf = readdirSync(folder).flatMap((model) =>
	readdirSync(join(folder, model))
		.filter((file) => !file.endsWith(".json"))
		.map((file) => ({ model, file, text: readFileSync(join(folder, model, file), "utf8") })),
);
const modelOf = async (text: string, file?: string) => (await readText(text, file)).model?.name;

describe("the model of a text", () => {
	it("is the one that has it as a preset, whatever its file is called", async () => {
		expect(new Set(shelf.map(({ model }) => model)).size).toBe(5);
		for (const { model, file, text } of shelf)
			for (const name of [file, "a.lsys", undefined]) expect([file, await modelOf(text, name)]).toEqual([file, model]);
	});

	it("is of L-systems that call symbols as growth grammars and plans begin their lines", async () => {
		expect(await modelOf("axiom: tree\ntree --> F [ tree ]", "a.growth")).toBe("growth");
		expect(await modelOf("axiom: tree\ntree --> F [ tree ]", "a.lsys")).toBe("grammar");
		expect(await modelOf("Axiom: tree\ntree --> F [ tree ]")).toBe("grammar");
		expect(await modelOf("axiom: A\nA --> F\n  plants , A")).toBe("grammar");
	});

	it("is by the ending of the file where the text has no sign of any", async () => {
		const endings = ["a.growth", "a.STAND", "a.gl3", "a.lsys", "a.txt", ".growth/a", undefined];
		expect(await Promise.all(endings.map((file) => modelOf("half a text", file)))).toEqual([
			"growth",
			"stand",
			"flower",
			"grammar",
			"grammar",
			"grammar",
			"grammar",
		]);
	});

	it("is the one that the file's first line names, unless that has no text", async () => {
		expect(await modelOf('/* Panicle ?v=2&model=stand */\ntree -> DivFunc("sigma1"){branches}')).toBe("stand");
		expect(await modelOf("/* Panicle ?v=2&model=leaf */\naxiom: F")).toBe("grammar");
		expect(await modelOf("/* Panicle ?v=2&model=constructor */\naxiom: F")).toBe("grammar");
	});
});

describe.each(["growth", "stand"])("a file of the text of a %s", (name) => {
	it("gives the specimen back, with its preset, seed and parameters", async () => {
		const model = (await modelNamed(name)) as Model;
		const preset = model.presets.list.at(-1)?.name;
		const specimen = { ...fromPreset(model, preset), seed: 77 };
		const format = model.formats?.find(({ suffix }) => suffix === `.${name}`);
		const file = String(await format?.make({} as never, specimen, ""));
		const read = await readText(file, "any.txt");
		expect(read.model?.name).toBe(name);
		expect(read.specimen).toEqual(specimen);
		expect(read.text).not.toContain("Panicle ?");
		expect(read.text.length).toBeGreaterThan(50);
		// Once more it is the same file.
		const again = await format?.make({} as never, { ...specimen, grammar: read.text } as never, "");
		expect(again).toBe(file);
	});
});

describe("the first line of such a file", () => {
	it("is read with the line ends and the byte order mark of other systems", () => {
		expect(readTextFile("\uFEFF/* Panicle ?v=2&model=growth */\r\ngs = 3")).toEqual({
			query: "?v=2&model=growth",
			text: "gs = 3",
		});
	});

	it("is a comment like others where it is no link's", () => {
		for (const text of ["/* Panicle */\na", "/* Panicle ?a b */\na", "a\n/* Panicle ?v=2 */\n", ""])
			expect(readTextFile(text)).toEqual({ query: undefined, text });
	});

	it("is never ended by what it says", async () => {
		const model = (await modelNamed("growth")) as Model;
		const schema = { ...model, details: [{ keys: ["x"], read: () => {}, query: () => [["x", "*/2"]] }] } as never;
		const file = writeTextFile(schema, fromPreset(model), "gs = 3");
		expect(file.split("*/")).toHaveLength(2);
		expect(new URLSearchParams(readTextFile(file).query).get("x")).toBe("*/2");
	});
});
