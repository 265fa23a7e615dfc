import fc from "fast-check";
import { describe, expect, it } from "vitest";
import {
	LONGEST_TEXT,
	readHistory,
	type StoredHistory,
	writeHistory,
} from "../../../../web/src/app/session/history_text";
import type { StoredSpecimen } from "../../../../web/src/app/session/stored_specimen";
import { LONGEST_HISTORY } from "../../../../web/src/specimen/history";

const step = (query: string, grammar?: string, extra?: string): StoredSpecimen => ({
	query,
	texts: grammar === undefined ? {} : { g: grammar },
	...(extra === undefined ? {} : { extra }),
});
const anyStep = fc
	.tuple(
		fc.string(),
		fc.option(fc.string({ unit: "grapheme" }), { nil: undefined }),
		fc.option(fc.json(), { nil: undefined }),
	)
	.map(([query, grammar, extra]) => step(`?${query}`, grammar, extra));
const anyHistory = fc.record({ past: fc.array(anyStep), present: anyStep, future: fc.array(anyStep) });

/** A history whose steps append a line each to a long text. */
function typed(steps: number, length: number): StoredHistory {
	const text = "F(1)[+F(2)]\n".repeat(length / 12);
	const past = Array.from({ length: steps }, (_, i) => step(`?v=2&seed=${steps - i}`, `${text}// line ${steps - i}\n`));
	return { past, present: step("?v=2", `${text}// now\n`), future: [] };
}

describe("a history as text", () => {
	it("brings any history back", () => {
		fc.assert(
			fc.property(anyHistory, (history) => {
				expect(readHistory(writeHistory(history) as string)).toEqual(history);
			}),
		);
	});

	it("has a long text once, however many steps share it or resemble it", () => {
		const history = typed(100, 120_000);
		const text = writeHistory(history) as string;
		expect(text.length).toBeLessThan(150_000);
		expect(readHistory(text)).toEqual(history);
		const [other, mesh] = ["other ".repeat(1000), JSON.stringify({ volume: { points: Array(3000).fill(0.25) } })];
		const turns = Array.from({ length: 50 }, (_, i) => step("?v=2", i % 2 ? other : history.present.texts.g, mesh));
		const back = writeHistory({ past: turns, present: history.present, future: [] }) as string;
		expect(back.length).toBeLessThan(160_000);
		expect(readHistory(back)?.past).toEqual(turns);
	});

	it("is limited: the steps nearest to the present stay, undo before redo", () => {
		const past = Array.from({ length: 30 }, (_, i) => step(`?past=${i}`, `${i}`.repeat(30_000)));
		const history = { past, present: step("?v=2"), future: past };
		const text = writeHistory(history) as string;
		expect(text.length).toBeLessThanOrEqual(LONGEST_TEXT);
		const read = readHistory(text) as StoredHistory;
		expect(read.past).toEqual(past.slice(0, read.past.length));
		expect(read.past.length).toBeGreaterThan(15);
		const short = writeHistory(history, 100_000) as string;
		expect(short.length).toBeLessThanOrEqual(100_000);
		expect(readHistory(short)?.past.length).toBeGreaterThan(0);
		expect(writeHistory({ past: [], present: step("?", "x".repeat(LONGEST_TEXT)), future: [] })).toBeUndefined();
	});

	it("has as many steps as a history", () => {
		const past = Array.from({ length: LONGEST_HISTORY + 50 }, (_, i) => step(`?${i}`));
		const text = writeHistory({ past, present: step("?"), future: [] }) as string;
		expect(readHistory(text)?.past).toHaveLength(LONGEST_HISTORY);
	});

	it("takes little time for 200 steps of the longest grammars", () => {
		const history = typed(200, 250_000);
		const start = performance.now();
		const text = writeHistory(history) as string;
		expect(readHistory(text)?.past).toHaveLength(200);
		expect(performance.now() - start).toBeLessThan(5000);
	});

	it.each([
		["no JSON", "{"],
		["a number", "7"],
		["null", "null"],
		["another version", JSON.stringify({ v: 2, pieces: [], present: { q: "?" }, past: [], future: [] })],
		["no pieces", JSON.stringify({ v: 1, present: { q: "?" }, past: [], future: [] })],
		["no present", JSON.stringify({ v: 1, pieces: [], past: [], future: [] })],
		["a present without a query", JSON.stringify({ v: 1, pieces: [], present: {}, past: [], future: [] })],
		["a long query", JSON.stringify({ v: 1, pieces: [], present: { q: "x".repeat(20_000) }, past: [], future: [] })],
		["a text that is too long", " ".repeat(LONGEST_TEXT + 1)],
		[
			"a difference from itself",
			JSON.stringify({ v: 1, pieces: [[0, 0, 0, ""]], present: { q: "?" }, past: [], future: [] }),
		],
		["a difference beyond the text", JSON.stringify({ v: 1, pieces: ["ab", [0, 2, 1, ""]], present: { q: "?" } })],
		["a negative length", JSON.stringify({ v: 1, pieces: ["ab", [0, -1, 0, ""]], present: { q: "?" } })],
	])("is ignored if it is %s", (_, text) => {
		expect(readHistory(text)).toBeUndefined();
	});

	it("does not expand differences without end", () => {
		const pieces: unknown[] = ["x".repeat(500_000)];
		for (let i = 0; i < 1000; i++) pieces.push([i, 500_000, 0, ""]);
		expect(readHistory(JSON.stringify({ v: 1, pieces, present: { q: "?" }, past: [], future: [] }))).toBeUndefined();
	});

	it("is read up to the first step that is invalid", () => {
		const record = {
			v: 1,
			pieces: ["a"],
			present: { q: "?" },
			past: [{ q: "?1" }, { q: "?2", t: { g: 9 } }, { q: "?3" }],
		};
		const read = readHistory(JSON.stringify({ ...record, future: 7 }));
		expect(read).toEqual({ past: [step("?1")], present: step("?"), future: [] });
	});
});
