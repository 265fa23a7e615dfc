import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { run } from "../../../web/src/cli/run";
import { complaint, memoryWorld } from "./world";

/** A text that never stops by itself: some 100 steps take as much work as the core looks at its clock once. */
const ENDLESS = "derivation length: 4096\naxiom: A\nA --> F(1) [+A] A\n";

/** Runs the command with a clock that moves on by so many milliseconds at each look; `looks` counts them. */
async function timed(words: string[], step: number, files: Record<string, string> = {}, written = new Map()) {
	const memory = memoryWorld(files, {}, written);
	let looks = 0;
	const status = await run(words, { ...memory.world, elapsed: () => step * looks++ });
	const [text = ""] = memory.printed;
	return { status, looks, ...memory, json: text === "" ? undefined : JSON.parse(text) };
}

const REPORTED =
	/^grow: --seconds 10: The time limit was reached. The plant was written as far as it had grown. Increase the limit/;

describe("--seconds", () => {
	it("ends a plant with what has grown so far, a note and status 5", async () => {
		const { status, json, messages } = await timed(["--grammar", "a.lsys", "--seconds", "10"], 500, {
			"a.lsys": ENDLESS,
		});
		expect(status).toBe(5);
		expect(messages).toEqual([expect.stringMatching(REPORTED)]);
		expect(json.notes[0]).toMatch(/^The plant is shown as far as it has grown\. The time limit was reached; /);
		expect(json.segments.length).toBeGreaterThan(100);
	});

	it("writes the same to a file", async () => {
		const words = ["--grammar", "a.lsys", "--seconds", "10", "--out", "a.glb"];
		const { status, messages, written } = await timed(words, 500, { "a.lsys": ENDLESS });
		expect(status).toBe(5);
		expect(written.has("a.glb")).toBe(true);
		expect(messages.filter((line) => REPORTED.test(line))).toHaveLength(1);
		expect(
			messages.filter((line) => line.startsWith("note: The plant is shown as far as it has grown. ")),
		).toHaveLength(1);
	});

	it("looks at the clock more often the more time there is, and grows more", async () => {
		const files = { "a.lsys": ENDLESS };
		const grown = await Promise.all(
			[1000, 100].map((step) => timed(["--grammar", "a.lsys", "--seconds", "10"], step, files)),
		);
		const [few, many] = grown;
		expect(few.looks).toBeLessThan(many.looks);
		expect(few.json.counts.steps).toBeLessThanOrEqual(many.json.counts.steps);
	});

	it("changes nothing of a plant that is whole in time", async () => {
		const words = ["grammar/shrub"];
		const [limited, free] = [await timed([...words, "--seconds", "10"], 1), await timed(words, 1)];
		expect([limited.status, limited.messages]).toEqual([0, []]);
		expect({ ...limited.json, timings: {} }).toEqual({ ...free.json, timings: {} });
	});

	it("ends a flower with what has grown so far", async () => {
		const { status, json } = await timed(["flower/meadow", "--seconds", "10"], 3000);
		expect(status).toBe(5);
		expect(json.notes[0]).toMatch(/^Growth ended in step \d+: the time limit was reached\. /);
	});

	it("ends a stand with the plants that are there", async () => {
		const { status, json, messages } = await timed(["stand/flowerbed", "--seconds", "10"], 100);
		expect(status).toBe(5);
		expect(messages).toEqual([expect.stringMatching(REPORTED)]);
		expect(json.notes).toContainEqual(
			expect.stringMatching(/^The time limit was reached, so only \d+ of \d+ different plants are shown\. /),
		);
	});

	it.each([
		["targets", ["riesling", "--target", "bunch_length=160"]],
		["a file that takes several growths", ["growth/oak", "--form", "lod", "--out", "a.glb"]],
	])("writes nothing with %s that are not whole in time", async (_, words) => {
		const { status, written, printed, messages } = await timed([...words, "--seconds", "10"], 4000);
		expect(status).toBe(5);
		expect([written.size, printed]).toEqual([0, []]);
		expect(messages.at(-1)).toMatch(
			/^grow: --seconds 10: The time limit was reached before there was anything to write. /,
		);
	});

	it("ends a series with the plants that are written, and the same call continues it", async () => {
		const words = ["redcurrant", "--set", "count=5", "--seeds", "1-9", "--as", "json", "--out", "d"];
		const some = await timed([...words, "--seconds", "10"], 700);
		expect(some.status).toBe(5);
		const [, count] =
			/(\d+) of 9 plants have been written\. Run the same command again to continue the series/.exec(
				some.messages.at(-1) ?? "",
			) ?? [];
		expect(Number(count)).toBeGreaterThan(0);
		expect(Number(count)).toBeLessThan(9);
		const files = [...some.written.keys()].filter((path) => path.endsWith(".json") && path !== "d/series.json");
		expect(files).toHaveLength(Number(count));
		const all = await timed(words, 0, {}, some.written);
		expect(all.status).toBe(0);
		expect(all.messages.at(-1)).toContain(`9 plants: ${9 - Number(count)} grown, ${count} already there`);
	});

	it("leaves the plant that the time limit cut short out of a series", async () => {
		const words = ["--grammar", "a.lsys", "--seeds", "1-2", "--as", "json", "--out", "d", "--seconds", "10"];
		const { status, written, messages } = await timed(words, 500, { "a.lsys": ENDLESS });
		expect(status).toBe(5);
		expect(messages.at(-1)).toContain("0 of 2 plants have been written");
		expect([...written.keys()].sort()).toEqual(["d/plants.csv.part", "d/series.json"]);
	});

	it("refuses what is no time", async () => {
		for (const seconds of ["0", "-1", "soon", "1e9", ""]) {
			expect(await complaint([`--seconds=${seconds}`])).toBe(
				`--seconds ${seconds}: Use a number from 0.1 to 1,000,000.`,
			);
		}
	});
});

describe("a plant that a limit of the core cut short", () => {
	it("is written, with a note and status 6", async () => {
		const { status, json, messages } = await timed(["--grammar", "a.lsys"], 0, { "a.lsys": ENDLESS });
		expect([status, messages]).toEqual([6, []]);
		expect(json.notes[0]).toMatch(
			/^The plant is shown as far as it has grown\. The (?:string|grammar) exceeds the limit/,
		);
	});
});

it("names the exit statuses in the help and in the docs", () => {
	const docs = readFileSync("docs/command-line.md", "utf8");
	for (const status of ["5", "6"]) expect(docs).toMatch(new RegExp(`^\\| ${status} \\| `, "m"));
});
