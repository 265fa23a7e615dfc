import { beforeAll, describe, expect, it } from "vitest";
import { independentDraws } from "../../../../web/src/batch/draws";
import { memberOf } from "../../../../web/src/batch/series";
import { checkVaried, readVary } from "../../../../web/src/batch/vary";
import { Axes } from "../../../../web/src/grammar_editor/gestures/axis";
import type { GrammarContext, GrammarSource } from "../../../../web/src/grammar_editor/source";
import { textOf, withText, withValues } from "../../../../web/src/grammar_editor/source";
import { FLOWER_FORMATS } from "../../../../web/src/models/flower/formats";
import { model } from "../../../../web/src/models/flower/index";
import { fetchedText, fetchTexts, variablesIn } from "../../../../web/src/models/flower/texts";
import { source as flowerSource } from "../../../../web/src/models/flower/ui/text";
import { writtenText } from "../../../../web/src/models/flower/written_text";
import { makeService } from "../../../../web/src/service/service";
import { compressText } from "../../../../web/src/specimen/compressed_text";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { decodeLink, encodeLink } from "../../../../web/src/specimen/link";
import { restore } from "../../../../web/src/specimen/restore";
import { writtenSpecimen } from "../../../../web/src/specimen/written";
import { complaint, grow } from "../../cli/world";
import { freshCore } from "../../core/wasm";

beforeAll(fetchTexts);

const source = flowerSource as unknown as GrammarSource;
const tulip = fromPreset(model, "tulip");
const split = (link: string): [string, string] => [link.replace(/#.*$/, ""), /#.*$/.exec(link)?.[0] ?? ""];
const taller = { ...tulip, constants: { length: 500 } };

describe("values of a flower's text", () => {
	it("are in its link by name, in short form, and in written texts", async () => {
		const link = await encodeLink(model, taller);
		expect(link).toBe("?v=2&model=flower&define=length:500");
		expect((await decodeLink(model, link, "")).specimen).toEqual(taller);
		expect(restore(model, writtenSpecimen(model, taller))).toEqual({ specimen: taller, notes: [] });
		expect(await encodeLink(model, tulip)).toBe("?v=2&model=flower");
	});

	it("are the text's own variables, not its modules'", async () => {
		expect(await variablesIn(tulip)).toEqual(["length", "bend", "scale", "tall", "size", "open", "wilt", "shed"]);
		const grammar =
			"@\n#define no=1\n@ /*\n#define nor=1\n*/\n #define a=2\n# define b =3\n#define C\n#define finalStep=3\n#axiom: C";
		expect(await variablesIn({ ...tulip, grammar })).toEqual(["a", "b"]);
	});

	it("change the flower as the text would, on the command line too", async () => {
		const printed = fromPreset(model, "table-3");
		const text = fetchedText(printed)?.replace("#define rd=7", "#define rd=9") ?? "";
		const { json } = await grow(["?v=2&model=flower&preset=table-3&define=rd:9,rdd:9"]);
		const written = await grow(["--grammar", "t.gl3"], { "t.gl3": text });
		expect(json.specimen.constants).toEqual({ rd: 9, rdd: 9 });
		expect(json.fingerprint).toBe(written.json.fingerprint);
		expect(json.notes).toContain(
			"The grammar has no “#define” for rdd, so these values have no effect. It defines rd.",
		);
		expect(await complaint(["flower/table-3", "--set", "rd=x"])).toContain("rd is “x”, which is not a number.");
	});

	it("go into the text of a file, comments stay", async () => {
		const text = "#define a=2*b/3 /* 1 … 2 */\n#define b=3@@\n#axiom: A\n#module M\n#define a=7\n";
		const { parameters } = tulip;
		expect(writtenText(text, { constants: { a: 1.5, b: -2, none: 4 }, parameters: { ...parameters, steps: 9 } })).toBe(
			"#define a=1.5 /* 1 … 2 */\n#define b=-2@@\n#axiom: A\n#define finalStep=9\n#module M\n#define a=7\n",
		);
		const gl3 = FLOWER_FORMATS.find(({ key }) => key === "gl3");
		expect(await gl3?.make({} as never, taller, "")).toContain("#define length=500 /* 160 … 530 mm");
	});
});

describe("a value", () => {
	const bluebell = { ...fromPreset(model, "bluebell"), constants: { bells: 5 } };

	it("of an expression is written into the shown text, as in the grown one", async () => {
		const text = textOf(source, bluebell, () => {}) ?? "";
		expect(text).toMatch(/^#define bells=5(?= |$)/m);
		expect(writtenText(fetchedText(bluebell) ?? "", bluebell)).toBe(text);
		const [set, written] = [
			await grow(["flower/bluebell", "--set", "bells=5"]),
			await grow(["--grammar", "b.gl3"], { "b.gl3": text }),
		];
		expect(written.json.fingerprint).toBe(set.json.fingerprint);
	});

	it("of such goes where its line is edited", () => {
		const text = (textOf(source, bluebell, () => {}) ?? "").replace(/^#define bells=5/m, "#define bells=2*4");
		expect(withText(source, bluebell, text)).toEqual({ details: { grammar: text, constants: {} } });
	});

	it("excludes finalStep: it has no slider, and is in no text", async () => {
		const poppy = { ...fromPreset(model, "poppy"), constants: { finalStep: 5 } };
		const text = fetchedText(poppy) ?? "";
		expect(text).toMatch(/^#define finalStep=\d+/m);
		const context = { state: { model, specimen: poppy } } as unknown as GrammarContext;
		const ids = new Axes(context, source, () => {}).all.map(({ id }) => id);
		expect(ids).toContain("constant length");
		expect(ids).toContain("parameter steps");
		expect(ids).not.toContain("constant finalStep");
		expect(textOf(source, poppy, () => {})).toBe(text);
		expect(withText(source, poppy, `${text}\n`)).toEqual({ details: { grammar: `${text}\n`, constants: {} } });
		expect(writtenText(text, poppy)).toBe(text);
	});

	it("is written before modules and beside comments, replacing all lines of its definition", () => {
		const written = (text: string, constants: Record<string, number>, steps = 0) =>
			writtenText(text, { constants, parameters: { ...tulip.parameters, steps } });
		expect(written("@ old:\n#define a=1\n@\n#define a=2\n", { a: 9 })).toBe("@ old:\n#define a=1\n@\n#define a=9\n");
		expect(written("/*\n#module M\n*/\n#define a=2", { a: 9 }, 4)).toBe(
			"/*\n#module M\n*/\n#define a=9\n#define finalStep=4\n",
		);
		expect(written("#define a=max(1,\n 2) @ so @\n#define b=1 <\n2\n", { a: 9, b: 8 })).toBe(
			"#define a=9 @ so @\n#define b=8\n",
		);
		expect(written("# define a=1 @ one @\n#define A(4)\n#define A=3\n# module M\n", { a: 2, A: 7 }, 5)).toBe(
			"# define a=2 @ one @\n#define A(4)\n#define A=7\n#define finalStep=5\n# module M\n",
		);
		expect(written("#define finalStep=1+\n(2)\n", {}, 6)).toBe("#define finalStep=6\n(2)\n");
	});
});

describe("an address", () => {
	const outputs: unknown[] = [];
	const loadCore = async (wasm: string) => {
		const core = await freshCore(wasm);
		const whole = core.grow.bind(core);
		core.grow = (blocks) => {
			outputs.push(blocks.find(({ name }) => name === "outputs")?.data);
			return whole(blocks);
		};
		return core;
	};
	const service = makeService({ loadCore, release: "1" });
	const get = async (address: string) => service(new Request(`http://plants.example/specimens/flower/${address}`));

	it("gives them by define= and by their bare names", async () => {
		const json = await Promise.all(
			["table-3.json?define=rd:9", "table-3.json?rd=9"].map(async (each) => (await get(each)).json()),
		);
		expect(json[0].specimen.constants).toEqual({ rd: 9 });
		expect(json[1]).toEqual(json[0]);
	});

	it("leaves the map out where it is not wanted, and refuses one that is too large to send", async () => {
		const { alpha, position, label, measures } = await (await get("table-3.json?file-map=0")).json();
		expect([alpha, position]).toEqual([undefined, undefined]);
		expect([label.length > 0, measures.surface > 0]).toEqual([true, true]);
		const grows = "#define A(24)\n#define finalStep=4\n#axiom: A\nA -> A[A(24)]_{E,C1,C2,C3,C4,C5,C6,C7,C8,C9,C10}";
		const address = `tulip.json?g=${await compressText(grows)}`;
		outputs.length = 0;
		const refused = await get(address);
		// Neither its mesh nor its map was built.
		expect(outputs).toEqual([""]);
		expect(`${refused.status} ${await refused.text()}`).toMatch(
			/^413 .*The flower’s map has [\d,]+ darts, more than the limit of 600,000\. Add file-map=0 to leave the map out\./,
		);
	});

	it.each([
		["tulip.obj?lenght=500", "lenght: The grammar does not define this constant. It defines length, bend, scale, tall"],
		["tulip.obj?define=K:5", "K: The grammar does not define this constant. It defines length"],
		["tulip.obj?length=x", "constants: length is “x”, which is not a number."],
		["figure-16.obj?a=1", "a: The grammar defines no constants."],
	])("%s is refused: %s", async (address, words) => {
		const answer = await get(address);
		expect([answer.status, await answer.json()]).toEqual([
			400,
			expect.objectContaining({ message: expect.stringContaining(words) }),
		]);
	});
});

describe("a series", () => {
	it("varies them, each drawn by its number", async () => {
		const varied = readVary(model, "length=200..400,bend=-1|0|1,age=0..2", tulip);
		await expect(checkVaried(model, varied, tulip)).resolves.toBeUndefined();
		const series = {
			model: model as never,
			from: tulip,
			varied,
			draws: independentDraws(model, tulip),
			formats: ["json"],
		};
		const members = await Promise.all([1, 2, 3, 4].map((number) => memberOf(series, number)));
		const lengths = members.map(({ specimen }) => (specimen as typeof tulip).constants.length);
		for (const length of lengths) expect(length >= 200 && length < 400).toBe(true);
		expect(new Set(lengths).size).toBe(4);
		expect(members[1].link).toMatch(/seed=\d+.*&define=bend:-?\d,length:[\d.]+$/);
		expect(members[1].values.map(Number)).toEqual([
			lengths[1],
			(members[1].specimen as typeof tulip).constants.bend,
			members[1].specimen.parameters.age,
		]);
	});

	it("rejects names that the text does not have, and invalid numbers", async () => {
		const unknown = readVary(model, "lenght=200..400", tulip);
		await expect(checkVaried(model, unknown, tulip)).rejects.toThrow("There is no parameter lenght. The grammar");
		// Other unknown names are reported there.
		const strange = { ...tulip, constants: { aaa: 1 } };
		for (const [vary, problem] of [
			["zzz=1..2", "no parameter zzz"] as const,
			["length=200..400", undefined] as const,
		]) {
			const checked = checkVaried(model, readVary(model, vary, strange), strange);
			if (problem) await expect(checked).rejects.toThrow(problem);
			else await expect(checked).resolves.toBeUndefined();
		}
		expect(() => readVary(model, "length=a..b", tulip)).toThrow("which is not a number.");
		expect(() => readVary(model, "length=4..2", tulip)).toThrow("is reversed");
	});
});

describe("a slider of a constant", () => {
	it("sets a value of the preset's text, and drops it if the text has it already", () => {
		const moved = withValues(source, tulip, { length: 400, bend: 0 });
		expect(moved).toEqual({ details: { constants: { length: 400 } } });
		expect(textOf(source, taller, () => {})).toContain("#define length=500 /*");
		expect(withValues(source, taller, { length: 325 })).toEqual({ details: { constants: {} } });
	});

	it("writes into a custom text, which then has the value", () => {
		const own = {
			...tulip,
			grammar: "#define length=3\n#define A(4,0,0,0,length,1,1,1)\n#axiom: A",
			constants: { length: 7, tall: 2 },
		};
		expect(textOf(source, own, () => {})).toContain("#define length=7\n");
		expect(withValues(source, own, { length: 9 })).toEqual({
			details: { grammar: own.grammar.replace("length=3", "length=9"), constants: { tall: 2 } },
		});
	});

	it("leaves text that is typed to be the document's own, unless it is the preset's", () => {
		const text = textOf(source, taller, () => {}) ?? "";
		expect(withText(source, taller, text)).toEqual({ details: { grammar: undefined, constants: { length: 500 } } });
		expect(withText(source, taller, fetchedText(tulip))).toEqual({ details: { grammar: undefined, constants: {} } });
		expect(withText(source, taller, `${text}\n`)).toEqual({ details: { grammar: `${text}\n`, constants: {} } });
		expect(withText(source, { ...taller, grammar: `${text}\n` } as never, undefined)).toEqual({
			details: { grammar: undefined, constants: {} },
		});
	});
	it("leaves the preset its text where a letter is typed and taken back, or a number alone is another", () => {
		const text = textOf(source, taller, () => {}) ?? "";
		const typed = { ...taller, ...(withText(source, taller, `${text}x`).details as object) };
		expect(typed).toMatchObject({ grammar: `${text}x`, constants: {} });
		expect(withText(source, typed, text)).toEqual({ details: { grammar: undefined, constants: { length: 500 } } });
		expect(withText(source, typed, text.replace("length=500", "length=50"))).toEqual({
			details: { grammar: undefined, constants: { length: 50 } },
		});
		// The digits are those of the text.
		const own = text.replace("length=500", "length=50.0");
		expect(withText(source, typed, own)).toEqual({ details: { grammar: own, constants: {} } });
	});

	it("is stored in its link, or else in its text", async () => {
		for (const [values, held] of [
			[{ length: 1e9 }, true],
			[{ length: 2e9 }, false],
			[{ length: 1e-50 }, false],
		] as const) {
			const { details } = withValues(source, tulip, values) as { details: object };
			const moved = { ...tulip, ...details };
			expect(moved.grammar === undefined).toBe(held);
			const again = (await decodeLink(model, ...split(await encodeLink(model, moved)))).specimen;
			expect(textOf(source, again, () => {})).toContain(`#define length=${values.length} `);
		}
	});

	it("is stored in its text if its name is too long for links", async () => {
		const name = "n".repeat(65);
		const long: GrammarSource = { ...source, builtIn: () => `#define ${name}=1\n` };
		expect(withValues(long, tulip, { [name]: 2 })).toEqual({
			details: { grammar: `#define ${name}=2\n`, constants: {} },
		});
	});
});
