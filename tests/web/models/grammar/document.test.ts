import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { titleOf } from "../../../../web/src/app/title";
import { modelForText } from "../../../../web/src/models/for_text";
import { model } from "../../../../web/src/models/grammar/index";
import { PRESETS } from "../../../../web/src/models/grammar/presets.generated";
import { fetchedText, presetText, textOf } from "../../../../web/src/models/grammar/texts";
import { titleOfText } from "../../../../web/src/models/grammar/words";
import { withValues } from "../../../../web/src/models/grammar/written_text";
import { MAX_CONSTANTS } from "../../../../web/src/specimen/constants";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { decodeLink, encodeLink } from "../../../../web/src/specimen/link";
import { restore } from "../../../../web/src/specimen/restore";
import { writtenSpecimen } from "../../../../web/src/specimen/written";

const standard = fromPreset(model);
const linked = async (specimen: typeof standard) => {
	const [query, hash] = (await encodeLink(model, specimen)).split("#");
	return decodeLink(model, query, hash);
};

describe("the document of a grammar", () => {
	it("comes through its link, its text in the fragment, constants and steps in the query", async () => {
		const grammar = "/* Mine */\n#define größe 3\naxiom: F(größe)";
		const constants = { größe: -1e-7, n: 12.125 };
		const specimen = { ...standard, seed: 4, steps: 0, constants, grammar };
		const link = await encodeLink(model, specimen);
		expect(link).toMatch(/^\?v=2&model=grammar&seed=4&steps=0&define=gr%C3%B6%C3%9Fe:-1e-7,n:12.125#g=/);
		expect(await linked(specimen)).toEqual({ specimen, notes: [] });
		expect(restore(model, writtenSpecimen(model, specimen))).toEqual({ specimen, notes: [] });
	});

	it("is only its preset's name if nothing else is set, and can unset a preset's values", async () => {
		expect(await encodeLink(model, standard)).toBe("?v=2&model=grammar");
		const { specimen } = restore(model, { define: "" }, { ...standard, constants: { a: 1 } });
		expect(specimen.constants).toEqual({});
	});

	it("has constants in the order of the alphabet, so that the same ones are the same document", () => {
		const read = (define: unknown) => restore(model, { define }).specimen.constants;
		expect(Object.keys(read("b:1,a:2"))).toEqual(["a", "b"]);
		expect(read({ b: 1, a: 2 })).toEqual(read("a:2,b:1"));
	});

	it.each([
		["a:x", "a is “x”, which is not a number."],
		["a:1e40", "a is “1e40”, which is not a number."],
		["a", "“” is not the name of a constant."],
		["2a:1", "“2a” is not the name of a constant."],
		[7, "“” is not the name of a constant."],
		[
			Array.from({ length: MAX_CONSTANTS + 1 }, (_, i) => `a${i}:1`).join(),
			`There are more than ${MAX_CONSTANTS} constants.`,
		],
	])("reports invalid parts of define=%s", (define, problem) => {
		const { specimen, notes } = restore(model, { define });
		expect(notes[0].problem).toBe(problem);
		expect(Object.keys(specimen.constants).length).toBeLessThanOrEqual(MAX_CONSTANTS);
	});

	it("brings steps into their range", () => {
		expect(restore(model, { steps: "5000" }).specimen.steps).toBe(4096);
		expect(restore(model, { steps: "-1" }).specimen.steps).toBe(0);
		expect(restore(model, { steps: "many" }).specimen.steps).toBeUndefined();
	});
});

describe("presets", () => {
	it("are the texts of their folder, without the gallery's part of their headers", async () => {
		for (const { name, text } of PRESETS) {
			const file = readFileSync(`wasm-core/grammars/grammar/${text}.lsys`, "utf8");
			const shown = await presetText(name);
			expect(shown).not.toMatch(/^\s*(kind|set):/m);
			expect(shown).toBe(file.replace(/^ +(kind|set): .*\n/gm, ""));
		}
	});

	it("come through their links, each with a title of its own", async () => {
		for (const { name } of PRESETS) {
			const specimen = fromPreset(model, name);
			expect(await linked(specimen)).toEqual({ specimen, notes: [] });
		}
		expect(new Set(PRESETS.map(({ title }) => title)).size).toBe(PRESETS.length);
	});

	it("grow by a custom text if there is one, which gives the title", async () => {
		const own = { ...standard, grammar: "/* Fern\n kind: plants */\naxiom: F" };
		expect(await textOf(own)).toBe(own.grammar);
		expect(fetchedText(own)).toBe(own.grammar);
		expect(titleOf(own, model as never)).toBe("Fern");
		expect(titleOf(standard, model as never)).toBe(PRESETS.find(({ name }) => name === standard.preset)?.title);
		expect(titleOfText("axiom: F")).toBe("A grammar of your own");
		expect(titleOfText("/* one line */ axiom: F")).toBe("one line");
	});
});

describe("a text without a model's name", () => {
	it("is the bunch's where it declares a bunch's roles, else this model's", async () => {
		expect((await modelForText("axiom: F"))?.name).toBe("grammar");
		expect((await modelForText("#role main A\naxiom: A"))?.name).toBe("grammar");
		expect((await modelForText("axiom: A\n #role pedicel A"))?.name).toBe("bunch");
	});
});

describe("the text as a file", () => {
	it("has constants and steps in it, comments stay", () => {
		const text = "#define a 3  /* 0 … 9 */\n#define ab a*2/4\nderivation length: 5 /* or so */\naxiom: F(a)\n";
		expect(withValues(text, { constants: { a: 1.5, ab: -2, none: 1 }, steps: 7 })).toBe(
			"#define a 1.5  /* 0 … 9 */\n#define ab -2\nderivation length: 7 /* or so */\naxiom: F(a)\n",
		);
		expect(withValues(text, { constants: {} })).toBe(text);
	});

	it("gets a derivation length where it has none", () => {
		expect(withValues("/* x */\naxiom: F\n", { constants: {}, steps: 2 })).toBe(
			"/* x */\nderivation length: 2\naxiom: F\n",
		);
	});
});
