import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { complaintOf, patternsIn } from "./patterns.mjs";

const SOURCES = "web/src";

it("no regular expression of the page, the service and the command line backtracks, and none is built as the program runs", () => {
	const files = readdirSync(SOURCES, { recursive: true, encoding: "utf8" });
	const found = files
		.filter((file) => file.endsWith(".ts") && !file.endsWith(".generated.ts"))
		.flatMap((file) => patternsIn(readFileSync(join(SOURCES, file), "utf8")).map((each) => ({ ...each, file })));
	expect(found.length).toBeGreaterThan(100);
	const complaints = found.flatMap((pattern) => {
		const why = pattern.built ? "composed at run time, so it cannot be checked: write a scanner" : complaintOf(pattern);
		return why === undefined ? [] : [`${pattern.file}:${pattern.line} ${pattern.text}: ${why}`];
	});
	expect(complaints).toEqual([]);
});

it.each([
	// They took minutes and more on links, files and arguments.
	[/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i, "Trade"],
	[/^\s*\/\*\s*([^\n*]{1,60}?)\s*(?:\n|\*\/)/, "Trade"],
	[/^([ \t]*length[ \t]*:[ \t]*)[^\n/]*?([ \t]*(?:\/\*.*)?)$/m, "Trade"],
	[/^[\s,;:]+|[\s,;:]+$/g, "Move"],
	[/^\s*#role\s+(rachis|axis|end|pedicel)\b/m, "Move"],
	[/,(?![^(]*\))/, "Move"],
	[/(?:"(?:[^"]|"")*"|[^"\r\n])*\r\n/g, "exponential"],
	[/@[^@]*@|\/\*[\s\S]*?\*\//g, "further beginnings"],
	[/\(([^)]*),([^)]*)\)/, "Trade"],
	[/\([^)]*\)=/, "Move"],
])("reports %s", ({ source, flags }, why) => expect(complaintOf({ source, flags })).toContain(why));

it.each([
	/^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[+-]?\d+)?$/i,
	/\/\*[\s\S]*?(?:\*\/|$)/g,
	/@[^@]*(?:@|$)/,
	/"[^"\n]*"?/g,
	/^[ \t]*#[ \t]*define[ \t]+(\p{L}[\p{L}\p{N}_]*)/gmu,
	/\s*(?:,\s*)?GrowVol\s*\(/y,
])("accepts %s", ({ source, flags }) => expect(complaintOf({ source, flags })).toBeUndefined());

it("finds the patterns of a source, and those that are composed at run time", () => {
	const code = 'const a = /x+/g;\n// /no/\nconst b = "/no/".split(/,/);\nnew RegExp(a.source, "u");\nRegExp("z");';
	expect(patternsIn(code).map(({ line, text, built }) => [line, text, built])).toEqual([
		[1, "/x+/g", false],
		[3, "/,/", false],
		[4, 'new RegExp(a.source, "u")', true],
		[5, 'RegExp("z")', true],
	]);
});
