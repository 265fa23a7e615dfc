import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { inRun } from "../../long_run.mjs";
import { restore, specimenFromPreset, writtenSpecimen } from "../bunch";
import { anySpecimen, faults } from "./arbitrary";

const texts = (record: unknown, from?: Parameters<typeof restore>[1]) =>
	restore(record, from).notes.map((note) => note.text);
const parameters = (record: unknown) => restore(record).specimen.parameters;

describe("restore", () => {
	it("gives the default bunch for nothing", () => {
		for (const nothing of [undefined, null, {}]) {
			expect(restore(nothing)).toEqual({ specimen: specimenFromPreset(), notes: [] });
		}
	});

	it("says what it assumes of a preset that is younger than a record without a version", () => {
		const assumed =
			"v: The version is missing, but the preset Riesling exists only since version 2. Version 1 was assumed. Add v=2 to get Riesling as it is shown here.";
		expect(texts({ preset: "riesling" })).toEqual([assumed]);
		expect(parameters({ preset: "riesling" }).procedure).toBe(0);
		expect(texts({ preset: "riesling", v: 2 })).toEqual([]);
		expect(texts({ preset: "riesling", v: 1 })).toEqual([]);
		expect(texts({ preset: "lychee" })).toEqual([]);
		expect(texts({ l: 300 })).toEqual([]);
		expect(texts({ preset: "riesling" }, specimenFromPreset())).toEqual([]);
	});

	it("gives a written specimen back as it is", () => {
		fc.assert(
			fc.property(anySpecimen, (specimen) => {
				const written = writtenSpecimen(specimen);
				for (const each of [specimen, written]) {
					expect(restore(JSON.parse(JSON.stringify(each)))).toEqual({ specimen, notes: [] });
				}
				expect(written.parameters.fruit).toBeTypeOf("string");
			}),
		);
	});

	it("gives a specimen in range for anything whatever, and is done with it the second time", () => {
		const values = fc.oneof(
			fc.anything(),
			fc.string(),
			fc.double(),
			fc.constantFrom("79,76", [1, 2], "1e999", "-0", "a.b.!"),
		);
		const keys = fc.oneof(
			fc.constantFrom("l", "p3", "p4w", "wing", "rmin", "rmax", "skin", "bloom", "seed", "m", "n", "preset", "v"),
			fc.constantFrom("thin", "thinned", "procedure", "fruit", "glow", "unripe"),
			fc.constantFrom("parameters", "look", "inputs", "grammar", "model", "__proto__", "constructor", "toString"),
			fc.string(),
		);
		const records = fc.oneof(fc.dictionary(keys, values), fc.anything());
		fc.assert(
			fc.property(records, (record) => {
				const { specimen, notes } = restore(record);
				expect(faults(specimen)).toEqual([]);
				expect(restore(specimen)).toEqual({ specimen, notes: [] });
				for (const { text } of notes) expect(text).toMatch(/^[^\n]{1,200}$/);
				expect(notes.length).toBeLessThanOrEqual(13);
			}),
			{ numRuns: inRun(400, 2000) },
		);
	});

	it("reads text and JSON's own values alike, by link key and by table key", () => {
		const expected = { p3w: 79, p3r: 76, unit: 0.3 };
		expect(parameters({ p3: "79,76", unit: "0.30" })).toMatchObject(expected);
		expect(parameters({ p3: [79, 76], unit: 0.3 })).toMatchObject(expected);
		expect(parameters({ p3w: "79", p3r: 76, parameters: { unit: 0.3 } })).toMatchObject(expected);
		expect(parameters({ p3: " 79 , 7.6e1 ", unit: ".3" })).toMatchObject(expected);
	});

	it("brings numbers into range and says so", () => {
		expect(texts({ l: 28 })).toEqual(["l: 28 is below the minimum, 29. Using 29."]);
		expect(texts({ l: Number.POSITIVE_INFINITY })).toEqual(["l: Infinity is above the maximum, 580. Using 580."]);
		expect(texts({ t: "2.5" })).toEqual(["t: 2.5 is not a whole number. Using 3."]);
		expect(parameters({ l: 28, t: 2.5, roll: "-181" })).toMatchObject({ l: 29, t: 3, roll: -180 });
	});

	it("raises what lies in the gap below the smallest second bunch", () => {
		expect(texts({ wing: 0.1 })).toEqual(["wing: 0.1 is between 0 and 0.3, where no value is allowed. Using 0.3."]);
		expect(parameters({ wing: 0.1 }).wing).toBe(0.3);
		expect(parameters({ wing: 0.0001 }).wing).toBe(0.3);
		expect(parameters({ wing: 0 }).wing).toBe(0);
		expect(parameters({ wing: 0.3 }).wing).toBe(0.3);
		expect(texts({ wing: -0.1 })).toEqual(["wing: -0.1 is below the minimum, 0. Using 0."]);
	});

	it("keeps what a link can hold: hundredths, without a word", () => {
		const { specimen, notes } = restore({ l: 500.126, sag: -0 });
		expect(specimen.parameters).toMatchObject({ l: 500.13, sag: 0 });
		expect(notes).toEqual([]);
	});

	it("passes over what is not a number", () => {
		for (const bad of ["", "12px", "0x10", "NaN", "Infinity", "--1", "1,2", true, [], {}, Number.NaN]) {
			const { specimen, notes } = restore({ l: bad });
			expect(specimen.parameters.l).toBe(512);
			expect(notes.map((note) => note.key)).toEqual(["l"]);
			expect(notes[0].text).toMatch(/is not a number\. Using 512\.$/);
		}
	});

	it("swaps the radii where the least is above the greatest", () => {
		expect(parameters({ rmin: 35 })).toMatchObject({ rmin: 30, rmax: 35 });
		expect(texts({ rmin: 35 })).toEqual(["rmin: 35 is greater than rmax (30). The two values were swapped."]);
	});

	it("takes colours as links and style sheets write them", () => {
		for (const skin of ["aabbcc", "#aabbcc", "#ABC", " AaBbCc "]) {
			expect(restore({ skin })).toMatchObject({ specimen: { look: { skin: "aabbcc" } }, notes: [] });
		}
		expect(texts({ skin: 123456 })).toEqual(["skin: 123456 is not a colour of six hexadecimal digits. Using 43264f."]);
	});

	it("starts from the preset named, whatever the order", () => {
		const { specimen } = restore({ l: "100", preset: "duku", v: 2 });
		expect(specimen).toEqual({
			...specimenFromPreset("duku"),
			parameters: { ...specimenFromPreset("duku").parameters, l: 100 },
		});
	});

	it("starts from a given specimen without touching it", () => {
		const from = specimenFromPreset("rubus");
		const before = structuredClone(from);
		const { specimen } = restore({ l: 99, skin: "000000", m: 4, seed: 5 }, from);
		expect(from).toEqual(before);
		expect(specimen).toMatchObject({ preset: "rubus", seed: 5, inputs: { m: 4 }, look: { skin: "000000" } });
		expect(specimen.parameters).toEqual({ ...before.parameters, l: 99 });
	});

	it("takes choices by name or by number, and lists the options where there is none such", () => {
		for (const fruit of ["lychee", " Lychee ", "3", 3, "3.0"]) expect(parameters({ fruit }).fruit).toBe(3);
		expect(parameters({ cane: "on", procedure: "natural" })).toMatchObject({ cane: 1, procedure: 1 });
		expect(texts({ v: 2, procedure: "wild" })).toEqual([
			"procedure: “wild” isn’t one of paper, natural. Using natural.",
		]);
		for (const bad of ["", "apple", 6, -1, 1.5, "1e999", true, ["lychee"], {}, Number.NaN, "length", "__proto__"]) {
			const { specimen, notes } = restore({ v: 2, preset: "longan", fruit: bad });
			expect(specimen.parameters.fruit).toBe(4);
			expect(notes).toHaveLength(1);
			expect(notes[0].text).toMatch(/^fruit: .* isn’t one of grape, currant, .*\. Using longan\.$/);
		}
	});

	it("takes berries thinned by hand: in base 36 as links list them, as numbers as files do", () => {
		const thinned = (record: unknown) => restore(record).specimen.thinned;
		expect(thinned({ thin: "a.1z" })).toEqual([10, 71]);
		expect(thinned({ thin: "10" })).toEqual([36]);
		expect(thinned({ thinned: [10, 71] })).toEqual([10, 71]);
		expect(thinned({ thinned: ["10", "71"] })).toEqual([10, 71]);
		expect(thinned({ thinned: 10 })).toEqual([10]);
		expect(texts({ thin: "a.1z.a", thinned: undefined })).toEqual([]);
		expect(restore({ thin: "b.a.b" })).toMatchObject({ specimen: { thinned: [11, 10] }, notes: [] });
	});

	it("lets a list of thinned berries replace the one before, and an empty one clear it", () => {
		const from = { ...specimenFromPreset(), thinned: [1, 2] };
		expect(restore({ l: 100 }, from).specimen.thinned).toEqual([1, 2]);
		expect(restore({ thin: "5" }, from).specimen.thinned).toEqual([5]);
		for (const none of [{ thin: "" }, { thin: " " }, { thinned: [] }]) {
			expect(restore(none, from)).toMatchObject({ specimen: { thinned: [] }, notes: [] });
		}
		expect(from.thinned).toEqual([1, 2]);
	});

	it("leaves out what is no berry's id and says so", () => {
		const left = (record: unknown) => restore(record).specimen.thinned;
		expect(left({ thin: "a.!.b" })).toEqual([10, 11]);
		expect(texts({ thin: "a.!.b" })).toEqual(["thin: “!” is not the id of a berry. This entry was left out."]);
		expect(texts({ thin: "hra0hs" })).toEqual(["thin: “hra0hs” is not the id of a berry. This entry was left out."]);
		expect(texts({ thinned: [-1, 1.5, 2 ** 30, "x", null, {}] })).toHaveLength(6);
		expect(left({ thinned: [-0, 2 ** 30 - 1] })).toEqual([0, 2 ** 30 - 1]);
		expect(texts({ thin: "a..b" })).toEqual(["thin: “” is not the id of a berry. This entry was left out."]);
	});

	it("takes off no more than five hundred", () => {
		const ids = Array.from({ length: 600 }, (_, id) => id);
		const { specimen, notes } = restore({ thinned: ids });
		expect(specimen.thinned).toEqual(ids.slice(0, 500));
		expect(notes.map(({ text }) => text)).toEqual([
			"thinned: More than 500 berries are removed. Only the first 500 berries are removed.",
		]);
		expect(texts({ thinned: [...ids.slice(0, 500), ...ids.slice(0, 500)] })).toEqual([]);
	});

	it("takes the grammar's inputs, and lets n say what m is", () => {
		expect(restore({ n: "1,2" }).specimen.inputs).toEqual({ m: 3, n: [1, 2] });
		expect(restore({ m: "3", n: [1, 2] }).specimen.inputs).toEqual({ m: 3, n: [1, 2] });
		expect(restore({ m: 5 }).specimen.inputs).toEqual({ m: 5 });
		expect(restore({ inputs: { m: 2, n: 4 } }).specimen.inputs).toEqual({ m: 2, n: [4] });
	});

	it("says which input it could not use", () => {
		expect(texts({ m: 5, n: "1,2" })).toEqual([
			"n: m = 5 needs 4 values, not 2. The values from the profile are used instead.",
		]);
		expect(texts({ m: 0 })).toEqual(["m: 0 is below the minimum, 1. Using 1."]);
		expect(texts({ m: "x" })).toEqual(["m: “x” is not a number. The value from the profile is used instead."]);
		expect(texts({ n: "1,,2" })).toEqual([
			"n: “1,,2” is not a list of numbers like “1,2”. The values from the profile are used instead.",
		]);
		expect(texts({ n: "1.5,200" })).toEqual([
			"n: 1.5 is not a whole number. Using 2.",
			"n: 200 is above the maximum, 100. Using 100.",
		]);
		expect(texts({ n: Array(150).fill(1) })).toEqual([
			"n: There are too many values (150). Only the first 99 values are used.",
		]);
	});

	it("takes a grammar as text that UTF-8 can hold, and no more of it than the core reads", () => {
		expect(restore({ grammar: "axiom: F(1)" }).specimen.grammar).toBe("axiom: F(1)");
		expect(restore({ grammar: "axiom: F\r\nF --> F" }).specimen.grammar).toBe("axiom: F\nF --> F");
		expect(restore({ grammar: "half \ud800 pair" }).specimen.grammar).toBe("half \ufffd pair");
		expect(restore({ grammar: "" }).specimen).not.toHaveProperty("grammar");
		expect(texts({ grammar: "ä".repeat(131_073) })).toEqual([
			"grammar: The grammar is longer than 256 KiB. The built-in grammar is used.",
		]);
		expect(texts({ grammar: 5 })).toEqual(["grammar: 5 is not text. The built-in grammar is used."]);
	});

	it("reads versions and models it does not know as those it does", () => {
		for (const v of ["1", 1, "2", 2]) expect(texts({ v, model: "bunch" })).toEqual([]);
		expect(texts({ v: 3 })).toEqual([
			"v: The plant was made with a newer version (3). Only the parts that this version supports were read.",
		]);
		expect(texts({ v: "x" })).toEqual(["v: “x” is not a version. Version 1 was assumed."]);
		for (const v of [0, -1, 1.5, "", [], true])
			expect(texts({ v })[0]).toMatch(/is not a version\. Version 1 was assumed/);
		expect(texts({ model: "flower" })).toEqual(["model: There is no model “flower” here. Using bunch."]);
	});

	it("reads a record of version 1, or of none, as the paper's procedure", () => {
		for (const old of [
			{ v: 1 },
			{ v: "1", preset: "duku" },
			{ preset: "duku" },
			{ l: 300 },
			{ parameters: { l: 300 } },
		]) {
			expect(restore(old).specimen).toMatchObject({ v: 2, parameters: { procedure: 0 } });
		}
		expect(restore({ v: 1, preset: "duku" }).specimen).toEqual({
			...specimenFromPreset("duku"),
			parameters: { ...specimenFromPreset("duku").parameters, procedure: 0 },
		});
		for (const now of [{ v: 2 }, { v: 3 }, { plum: 1 }, { model: "bunch", preset: "duku" }]) {
			expect(restore(now).specimen).toMatchObject({ v: 2, parameters: { procedure: 1 } });
		}
	});

	it("does not turn a specimen of now into an old one by adding to it", () => {
		const from = specimenFromPreset("rubus");
		expect(restore({ l: 100 }, from).specimen.parameters.procedure).toBe(1);
		expect(restore({ preset: "duku" }, from).specimen).toEqual(specimenFromPreset("duku"));
		const old = specimenFromPreset("rubus", 1);
		expect(restore({ l: 100 }, old).specimen.parameters.procedure).toBe(0);
	});

	it("keeps notes few and short, however much is wrong", () => {
		const record = Object.fromEntries(Array.from({ length: 50 }, (_, i) => [`bad${i}\n${"x".repeat(99)}`, "y"]));
		const { notes } = restore(record);
		expect(notes).toHaveLength(13);
		expect(notes.at(-1)?.text).toBe("38 more parts could not be used.");
		for (const { text } of notes) expect(text.length).toBeLessThan(90);
	});

	it("is not led astray by names that every object has", () => {
		const record = JSON.parse(
			'{"__proto__": {"l": 100}, "constructor": 1, "parameters": {"toString": 2, "__proto__": 3}}',
		);
		const { specimen, notes } = restore(record);
		expect(specimen).toEqual(specimenFromPreset(undefined, 2));
		expect(notes.map((note) => note.key)).toEqual(["__proto__", "constructor", "toString", "__proto__"]);
	});
});
