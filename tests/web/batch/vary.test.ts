import { describe, expect, it } from "vitest";
import { independentDraws } from "../../../web/src/batch/draws";
import { readPlantNumbers } from "../../../web/src/batch/plant_numbers";
import { partOf } from "../../../web/src/batch/shard";
import { drawn, readVary } from "../../../web/src/batch/vary";
import { crc32Digits } from "../../../web/src/formats/crc32";
import { model } from "../../../web/src/models/bunch/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";

const from = fromPreset(model, "merlot");
const of = (text: string) => readVary(model, text, from);
const many = Array.from({ length: 4000 }, (_, number) => number);
const draws = independentDraws(model, from);

describe("what a plant of a series draws", () => {
	it("fills a range evenly, on the steps that a link can hold", () => {
		const [age] = of("age=60..110");
		const ages = many.map((number) => Number(drawn(age, number, draws)));
		for (let tenth = 0; tenth < 10; tenth++) {
			const inside = ages.filter((value) => value >= 60 + 5 * tenth && value < 65 + 5 * tenth).length;
			expect(inside).toBeGreaterThan(330);
			expect(inside).toBeLessThan(470);
		}
		for (const value of ages) expect(Math.round(100 * value) / 100).toBe(value);
	});

	it("takes each whole number, and each of a list, as often as the others", () => {
		const [count] = of("count=20..23");
		const [fruit] = of("fruit=lychee|duku|0");
		for (const [varied, options] of [
			[count, ["20", "21", "22", "23"]],
			[fruit, ["lychee", "duku", "0"]],
		] as const) {
			const values = many.map((number) => drawn(varied, number, draws));
			expect([...new Set(values)].sort()).toEqual([...options].sort());
			for (const option of options) {
				const share = values.filter((value) => value === option).length / many.length;
				expect(share).toBeCloseTo(1 / options.length, 1);
			}
		}
	});

	it("is the same whatever else is varied, and of two parameters not the same", () => {
		const [alone] = of("age=0..100");
		const [, beside] = of("density=3..8,age=0..100");
		expect(many.map((number) => drawn(beside, number, draws))).toEqual(
			many.map((number) => drawn(alone, number, draws)),
		);
		expect([1, 2, 3].map((number) => drawn(alone, number, draws))).toEqual(["97.13", "51.92", "84.97"]);
		const [size] = of("size=5..25");
		const shares = many.map((number) => [
			Number(drawn(alone, number, draws)) / 100,
			(Number(drawn(size, number, draws)) - 5) / 20,
		]);
		const mean = shares.reduce((sum, [one, other]) => sum + (one - 0.5) * (other - 0.5), 0) / many.length;
		expect(Math.abs(mean)).toBeLessThan(0.005);
	});
});

it("numbers of plants are read once each, in the order written", () => {
	expect(readPlantNumbers("3-5, 1,4,4294967295")).toEqual([3, 4, 5, 1, 4294967295]);
});

it("parts follow one another and differ by one plant at the most", () => {
	const items = many.slice(0, 101);
	for (const total of [1, 2, 7, 16, 101, 200]) {
		const parts = Array.from({ length: total }, (_, at) => partOf(items, { index: at + 1, total }));
		expect(parts.flat()).toEqual(items);
		const sizes = parts.map((part) => part.length);
		expect(Math.max(...sizes) - Math.min(...sizes)).toBeLessThanOrEqual(1);
	}
});

it("CRC-32 is the one of ZIP and PNG", () => {
	expect(crc32Digits(new TextEncoder().encode("123456789"))).toBe("cbf43926");
	expect(crc32Digits(new Uint8Array())).toBe("00000000");
});
