import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { globals, repeatedTypes, shadows, shadowsIn } from "./names.mjs";
import { avoidedWords, usesIn } from "./words.mjs";

interface Allowed {
	file: string;
	found: string;
	reason: string;
}

const allowed: Allowed[] = JSON.parse(readFileSync(new URL("./words.allowed.json", import.meta.url), "utf8"));
const found = (text: string) => avoidedWords(text).map((use) => use.found);

describe("names and comments", () => {
	it("use no avoided word but those that words.allowed.json lists with a reason", () => {
		const uses = usesIn();
		const isAllowed = (use: { file: string; found: string }) =>
			allowed.some((each) => each.file === use.file && each.found === use.found);
		expect(
			uses.filter((use) => !isAllowed(use)).map(({ file, line, found: word }) => `${file}:${line}: ${word}`),
		).toEqual([]);
		const isUsed = (each: Allowed) => uses.some((use) => use.file === each.file && use.found === each.found);
		expect(allowed.filter((each) => !isUsed(each))).toEqual([]);
	});

	it("have at most 40 allowed uses, each with a reason", () => {
		expect(usesIn().length).toBeLessThanOrEqual(40);
		expect(allowed.filter(({ reason }) => reason.length < 10)).toEqual([]);
	});

	it("are searched for words in identifiers and comments, but not in strings", () => {
		expect(found("const askedFor = 1;")).toEqual(["askedFor"]);
		expect(found("int told_module(int kept);")).toEqual(["told_module", "kept"]);
		expect(found("// What is laid here")).toEqual(["laid", "What"]);
		expect(found("/** Kept for ever. */")).toEqual(["Kept", "for ever"]);
		expect(found('const text = "what was asked";')).toEqual([]);
		expect(found(["const text = `asked $", "{told} of $", "{them}`;"].join(""))).toEqual(["told"]);
		expect(found("const basket = essays.layer(delay);")).toEqual([]);
	});
});

describe("types of web/src", () => {
	it("hide no global of the browser or the language", () => {
		expect(shadows()).toEqual([]);
		expect(shadowsIn("export interface Range {}\nconst own = 1;\nfunction close() {}", globals())).toEqual([
			"Range",
			"close",
		]);
	});

	it("have names of their own in each folder", () => {
		expect(repeatedTypes()).toEqual([]);
		const texts = [
			["web/src/plant/a.ts", "export interface Vector {}"],
			["web/src/render/b.ts", "export type Vector = number;\nexport class Only {}"],
		];
		expect(repeatedTypes(texts)).toEqual(["Vector: plant, render"]);
	});
});
