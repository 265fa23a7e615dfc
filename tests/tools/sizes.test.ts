import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { lastRelease } from "../sizes/check.mjs";
import { compare, limitOf, missingLines, statedSince } from "../sizes/compare.mjs";

const last = {
	version: "2.0.0",
	date: "2026-01-02",
	emscripten: "3.1.6",
	sizes: { "bunch.wasm": 100_000, "first load: code": 400_000, fonts: 1000, "number of files": 500 },
};
const same = { stated: {}, emscripten: "3.1.6" };
const section = (name: string, lines = "") =>
	`## [${name}]\n\n### Added\n\n- Figs\n\n### Sizes\n\n${lines}\n\n### Fixed\n\n- Dates\n\n`;
const RISE = "- `first load: code`: 400,000 → 420,000 bytes: a model more";

describe("comparing sizes with the last release", () => {
	it("accepts what is at most 2 % larger, or a few bytes, and lists every row", () => {
		const now = {
			"bunch.wasm": 102_000,
			"first load: code": 390_000,
			fonts: 1200,
			"number of files": 510,
			"moss.wasm": 7,
		};
		const { table, problems } = compare(now, last, same);
		expect(problems).toEqual([]);
		expect(table.split("\n").map((line) => line.trim().split(/ {2,}/))).toEqual([
			["now", "2.0.0", "change"],
			["bunch.wasm", "102,000", "100,000", "+2.0 %"],
			["first load: code", "390,000", "400,000", "−2.5 %"],
			["fonts", "1,200", "1,000", "+20.0 %"],
			["number of files", "510", "500", "+2.0 %"],
			["moss.wasm", "7", "–", "new"],
		]);
	});

	it("refuses what is larger, with the line that would state it", () => {
		const now = { "bunch.wasm": 102_257, "first load: code": 408_256, fonts: 1277, "number of files": 511 };
		expect(compare(now, last, same).problems).toEqual([
			"- `bunch.wasm`: 100,000 → 102,257 bytes: REASON",
			"- `fonts`: 1,000 → 1,277 bytes: REASON",
			"- `number of files`: 500 → 511 files: REASON",
		]);
	});

	it("lists rows that were not measured", () => {
		expect(compare({}, last, same).table).toMatch(/^ {2}fonts +not measured +1,000$/m);
	});

	it("shows cores of another compiler, and compares only the other rows", () => {
		const { table, problems } = compare({ "bunch.wasm": 150_000, fonts: 2000 }, last, {
			...same,
			emscripten: "3.1.69",
		});
		expect(problems).toEqual(["- `fonts`: 1,000 → 2,000 bytes: REASON"]);
		expect(table).toMatch(/\+50\.0 % \(other compiler\)/);
	});
});

describe("rises that the changelog states", () => {
	it("are accepted up to 2 % over what it states, where it gives a reason", () => {
		const stated = statedSince(section("Unreleased", RISE) + section("2.0.0"), "2.0.0");
		expect(stated).toEqual({ "first load: code": 420_000 });
		expect(limitOf("first load: code", last, stated)).toBe(428_656);
		expect(limitOf("fonts", last, stated)).toBe(1276);
		expect(limitOf("moss", last, stated)).toBeUndefined();
		expect(statedSince(section("Unreleased", RISE.replace("a model more", "REASON")), "2.0.0")).toEqual({});
	});

	it("count where they are in sections since the last release, the newest first", () => {
		const newer = RISE.replace("420,000", "430,000");
		expect(statedSince(section("Unreleased", newer) + section("2.1.0-rc.1", RISE) + section("2.0.0"), "2.0.0")).toEqual(
			{
				"first load: code": 430_000,
			},
		);
		expect(statedSince(section("Unreleased") + section("2.0.0", RISE), "2.0.0")).toEqual({});
		// A release that is recorded before its section is written.
		expect(statedSince(section("Unreleased", RISE) + section("1.0.0", newer), "2.0.0")).toHaveProperty(
			["first load: code"],
			420_000,
		);
	});

	it("are to be in the section of a release, for each row that rose since the release before", () => {
		const previous = { version: "1.0.0", emscripten: "3.1.6", sizes: { ...last.sizes, "first load: code": 380_000 } };
		const risen = { ...last, previous };
		const line = "- `first load: code`: 380,000 → 400,000 bytes: REASON";
		expect(missingLines(risen, section("2.0.0"))).toEqual([line]);
		expect(missingLines(risen, "")).toEqual([line]);
		expect(missingLines(risen, section("2.0.0", line.replace("REASON", "a model more")))).toEqual([]);
		expect(missingLines(last, "")).toEqual([]);
	});
});

it("the changelog states each rise of the last release, in its section under “### Sizes”", () => {
	expect(missingLines(lastRelease(), readFileSync("CHANGELOG.md", "utf8"))).toEqual([]);
});
