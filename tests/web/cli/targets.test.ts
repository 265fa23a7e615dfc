import { describe, expect, it } from "vitest";
import { encodeQuery, restore } from "../bunch";
import { complaint, grow } from "./world";

const target = (...texts: string[]) => texts.flatMap((text) => ["--target", text]);

describe("a target", () => {
	it("is met by other parameters, which the file holds, and said how near", async () => {
		const { status, json, messages } = await grow(["riesling", ...target("bunch_length=160")]);
		expect(status).toBe(0);
		expect(json.measures.bunch_length).toBeGreaterThan(157);
		expect(json.measures.bunch_length).toBeLessThan(163);
		expect(messages).toEqual([
			expect.stringMatching(/^target: Bunch length: 160 mm reached$/),
			expect.stringMatching(/^target: Length 115\.1 → [\d.]+ mm, .* and \d more, after \d+ tr(y|ies)$/),
		]);
		const { specimen } = restore(json.specimen);
		const again = await grow([encodeQuery(specimen)]);
		expect(again.json.fingerprint).toBe(json.fingerprint);
	});

	it("from a range is drawn from it by the seed, and met within it", async () => {
		const words = ["riesling", ...target("bunch_length=120..180")];
		const lengths = [];
		for (const seed of ["1", "2", "3", "4"]) {
			const { status, json, messages } = await grow([...words, "--seed", seed]);
			expect([status, messages[0]]).toEqual([0, expect.stringMatching(/^target: Bunch length: [\d.]+ mm reached/)]);
			lengths.push(json.measures.bunch_length);
		}
		for (const length of lengths) expect(length > 119.5 && length < 180.5).toBe(true);
		expect(Math.max(...lengths) - Math.min(...lengths)).toBeGreaterThan(15);
	});

	it("stands beside others, and beside what is set", async () => {
		const words = ["merlot", "--set", "age=90", ...target("bunch_length=200", "berry_width=16")];
		const { json, messages } = await grow(words);
		expect(json.specimen.parameters.age).toBe(90);
		expect(Math.abs(json.measures.bunch_length - 200)).toBeLessThan(5);
		expect(Math.abs(json.measures.berry_width - 16)).toBeLessThan(0.4);
		expect(messages).toHaveLength(3);
	});

	it("out of reach gives the nearest", async () => {
		const { status, json, messages } = await grow(["riesling", ...target("pedicel_length=500")]);
		expect(status).toBe(3);
		expect(json.specimen.parameters.pedicel).toBe(60);
		expect(messages[0]).toMatch(/wanted 500\.0 mm, got [\d.]+ mm \(the settings are at their limit\)$/);
	});

	it("that cannot be used is refused", async () => {
		const refused = (...texts: string[]) => complaint(["riesling", ...target(...texts)]);
		expect(await refused("160")).toBe("--target 160: Write MEASURE=VALUE, as in --target bunch_length=160.");
		expect(await refused("wings=2")).toMatch(/^--target wings: No such measure can be a target for this plant/);
		expect(await refused("density=high")).toBe("--target density: A target must be 0 or greater, not “high”.");
		expect(await refused("density=-1")).toMatch(/A target must be 0 or greater, not “-1”\.$/);
		expect(await refused("bunch_length=9..x")).toBe("--target bunch_length: A target must be 0 or greater, not “x”.");
		expect(await refused("bunch_length=9..3")).toBe("--target bunch_length: The range 9..3 is reversed. Write 3..9.");
		expect(await refused("density=3", "density=4")).toBe(
			"--target density: This measure has two targets. Give it only one.",
		);
		expect(await complaint(["root", ...target("depth=3")])).toMatch(
			/The model root has no measures that can be targets/,
		);
		const paper = ["riesling", "--set", "procedure=paper", ...target("density=3")];
		expect(await complaint(paper)).toMatch(/No such measure can be a target for this plant/);
	});

	it("is in the help of models that have some", async () => {
		const { printed } = await grow(["--help"]);
		expect(printed[0]).toMatch(/--target M=VALUE[^-]*bunch_length bunch_width/);
		expect((await grow(["root", "--help"])).printed[0]).not.toContain("--target M=");
	});
});

describe("a series with a target", () => {
	const words = ["redcurrant", "--seeds", "1-2", "--as", "json", "--out", "d", ...target("berry_width=10")];
	const cells = (text: unknown) => {
		const [header, ...rows] = String(text)
			.trimEnd()
			.split("\r\n")
			.map((row) => [...row.matchAll(/(?:^|,)(?:"([^"]*)"|([^,]*))/g)].map(([, quoted, plain]) => quoted ?? plain));
		return rows.map((row) => Object.fromEntries(row.map((cell, at) => [header[at], cell])));
	};

	it("finds parameters for every seed; each comes back from its line", async () => {
		const { status, written } = await grow(words);
		expect(status).toBe(0);
		const rows = cells(written.get("d/plants.csv"));
		expect(rows.map(({ target_berry_width }) => target_berry_width)).toEqual(["10", "10"]);
		for (const { link, from, fingerprint, berry_width } of rows) {
			expect(Number(berry_width)).toBeCloseTo(10, 0);
			expect(link).not.toBe(from);
			expect((await grow([link])).json.fingerprint).toBe(fingerprint);
		}
	});

	it("draws a value of a range for every plant, and spreads plants over it", async () => {
		const drawn = [
			"redcurrant",
			"--set",
			"count=8",
			"--seeds",
			"1-12",
			"--as",
			"csv",
			"--out",
			"d",
			...target("berry_width=6..14"),
		];
		const { status, written } = await grow(drawn);
		expect(status).toBe(0);
		const rows = cells(written.get("d/plants.csv"));
		for (const { target_berry_width, berry_width } of rows) {
			expect(Number(target_berry_width) >= 6 && Number(target_berry_width) < 14).toBe(true);
			expect(Math.abs(Number(berry_width) - Number(target_berry_width))).toBeLessThan(0.3);
		}
		const widths = rows.map(({ berry_width }) => Number(berry_width));
		expect(Math.max(...widths) - Math.min(...widths)).toBeGreaterThan(4);
		expect(rows.map(({ missed }) => missed).join("")).toBe("");
	});

	it("ends with 3 where a plant misses it, and again where it is taken up", async () => {
		const missing = [
			"redcurrant",
			"--set",
			"count=5",
			"--seeds",
			"1-2",
			"--as",
			"csv",
			"--out",
			"d",
			...target("pedicel_length=500"),
		];
		const { status, messages, written } = await grow(missing);
		expect(status).toBe(3);
		expect(messages).toEqual([
			"2 plants: 2 grown, 0 already there; d/plants.csv",
			"target: 2 of 2 plants miss a target; the table’s “missed” column lists the measures",
		]);
		const rows = cells(written.get("d/plants.csv"));
		expect(rows.map(({ missed }) => missed)).toEqual(["pedicel_length", "pedicel_length"]);
		expect(rows[0].notes).toMatch(/wanted 500\.0 mm/);
		const again = await grow(missing, Object.fromEntries(written));
		expect([again.status, again.messages[0]]).toEqual([3, "2 plants: 0 grown, 2 already there; d/plants.csv"]);
	});

	it("is not grown again where it is there, and refused where it is of another target", async () => {
		const { written } = await grow(words);
		const there = Object.fromEntries(written);
		expect((await grow(words, there)).messages).toEqual(["2 plants: 0 grown, 2 already there; d/plants.csv"]);
		const other = [...words.slice(0, -1), "berry_width=8"];
		expect(await complaint(other, there)).toMatch(/\(--target berry_width: 10 in the folder, 8 now\)/);
	});
});
