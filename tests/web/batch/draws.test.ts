import { beforeAll, describe, expect, it } from "vitest";
import { type Draws, independentDraws, literalDraws } from "../../../web/src/batch/draws";
import { model } from "../../../web/src/models/bunch/index";
import type { BunchSpecimen } from "../../../web/src/models/bunch/specimen";
import { withParameters } from "../../../web/src/specimen/edit";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { freshCore, growBunch } from "../core/wasm";

const of = (preset: string, settings: Record<string, number> = {}) =>
	withParameters(model, fromPreset(model, preset), settings);
const riesling = independentDraws(model, of("riesling"));

const mean = (values: readonly number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
const deviation = (values: readonly number[]) => Math.sqrt(mean(values.map((value) => (value - mean(values)) ** 2)));

function correlation(one: readonly number[], other: readonly number[]): number {
	const [a, b] = [mean(one), mean(other)];
	return mean(one.map((value, i) => (value - a) * (other[i] - b))) / (deviation(one) * deviation(other));
}

/** The largest distance between the distribution of shares and the uniform one (Kolmogorov and Smirnov), times √n: above 1.63 once in a hundred times. */
function kolmogorov(shares: readonly number[]): number {
	const sorted = shares.toSorted((one, other) => one - other);
	const apart = sorted.map((share, i) => Math.max(share - i / sorted.length, (i + 1) / sorted.length - share));
	return Math.sqrt(sorted.length) * Math.max(...apart);
}

/** Numbers that are counted up, and with strides at which multiples of the golden ratio repeat: Fibonacci's. */
const STRIDES = [1, 2, 8, 89, 144, 987, 65536];
const COUNT = 2000;
const numbers = (stride: number) => Array.from({ length: COUNT }, (_, k) => 1 + stride * k);

describe("shares and seeds of a series", () => {
	it.each(STRIDES)("are uniform and without a trend at a stride of %i", (stride) => {
		for (const share of [
			(number: number) => riesling.share("vary age", number),
			(number: number) => riesling.seed(number) / 2 ** 32,
		]) {
			const shares = numbers(stride).map(share);
			expect(kolmogorov(shares)).toBeLessThan(1.63);
			// As far from the uniform distribution as random numbers are: evenly spaced ones come nearer.
			expect(kolmogorov(shares)).toBeGreaterThan(0.35);
			for (const lag of [1, 2, 3]) {
				expect(Math.abs(correlation(shares.slice(lag), shares.slice(0, -lag)))).toBeLessThan(3.3 / Math.sqrt(COUNT));
			}
		}
	});

	it("are independent between quantities, varieties and settings", () => {
		const shares = (draws: Draws, quantity: string) => numbers(1).map((number) => draws.share(quantity, number));
		const others = [
			shares(riesling, "vary size"),
			shares(independentDraws(model, of("merlot")), "vary age"),
			shares(independentDraws(model, of("riesling", { density: 3 })), "vary age"),
			numbers(1).map((number) => riesling.seed(number) / 2 ** 32),
		];
		for (const other of others) {
			expect(Math.abs(correlation(shares(riesling, "vary age"), other))).toBeLessThan(3.3 / Math.sqrt(COUNT));
		}
	});

	it("depend on nothing else: not on the seed that the series began with, nor on the order", () => {
		const another = independentDraws(model, { ...of("riesling"), seed: 99 });
		const [last, first] = [another.seed(7), another.seed(1)];
		expect([first, last]).toEqual([riesling.seed(1), riesling.seed(7)]);
	});

	it("give no two plants of a series one seed", () => {
		const seeds = new Set(Array.from({ length: 100_000 }, (_, number) => riesling.seed(number)));
		expect(seeds.size).toBe(100_000);
		for (const seed of seeds) if (!(seed >= 0 && seed <= 0xffffffff)) throw new Error(`${seed} is no seed.`);
	});

	it("are the numbers themselves, and the same for all, where pairs are to be compared", () => {
		expect([0, 7, 0xffffffff].map((number) => literalDraws().seed(number))).toEqual([0, 7, 0xffffffff]);
		expect(literalDraws().share("vary age", 7)).toBe(literalDraws().share("vary age", 7));
		expect(literalDraws().share("vary age", 7)).not.toBe(literalDraws().share("vary size", 7));
	});
});

describe("lengths of the bunches of a series", () => {
	/** Of the profile that each bunch fills, over the preset's. */
	let lengths: (preset: string, seeds: readonly number[]) => number[];

	beforeAll(async () => {
		const core = await freshCore();
		lengths = (preset, seeds) =>
			seeds.map((seed) => {
				const specimen: BunchSpecimen = { ...of(preset), seed };
				const { profile } = growBunch(core, specimen, { meshes: false, measures: false });
				return (profile?.l ?? Number.NaN) / specimen.parameters.l;
			});
	});

	const every = (stride: number, length = 120) => Array.from({ length }, (_, k) => 1 + stride * k);
	const drawn = (preset: string, stride: number) => every(stride).map(independentDraws(model, of(preset)).seed);

	it("vary as much at any stride, as those of seeds do not", () => {
		const variation = (values: readonly number[]) => deviation(values) / mean(values);
		expect(variation(lengths("riesling", every(144, 30)))).toBeLessThan(0.03);
		for (const stride of [1, 144]) {
			const found = variation(lengths("riesling", drawn("riesling", stride)));
			expect(found).toBeGreaterThan(0.12);
			expect(found).toBeLessThan(0.18);
		}
	});

	it("of one variety say nothing of another's, as those of seeds do", () => {
		const [one, other] = ["riesling", "merlot"];
		expect(correlation(lengths(one, every(1)), lengths(other, every(1)))).toBeGreaterThan(0.95);
		expect(Math.abs(correlation(lengths(one, drawn(one, 1)), lengths(other, drawn(other, 1))))).toBeLessThan(0.3);
	});
});
