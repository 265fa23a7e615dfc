import { describe, expect, it, vi } from "vitest";
import { specimenFromPreset } from "../../../web/src/models/bunch/schema";
import type { BunchSpecimen } from "../../../web/src/models/bunch/specimen";
import { proportionalLever } from "../../../web/src/targets/lever";
import { MAX_GROWTHS, type SolverCallbacks, solve } from "../../../web/src/targets/solve";
import { changesInWords, reachedInWords } from "../../../web/src/targets/words";
import { BUNCH } from "../bunch";

const KEYS = BUNCH.table.measures.map(({ key }) => key);
const place = (key: string) => KEYS.indexOf(key);

/** A plant with known measures: its length is `l`, its weight `size` cubed times `l`. */
const measure: SolverCallbacks<BunchSpecimen>["measure"] = async ({ parameters: { l, size, count } }) => {
	const values = new Float32Array(KEYS.length).fill(Number.NaN);
	values[place("bunch_length")] = 0.4 * l + 10;
	values[place("bunch_weight")] = 0.0001 * l * size ** 3;
	values[place("berry_count")] = count > 0 ? count : 90;
	return values;
};

const levers = {
	bunch_length: [proportionalLever(BUNCH, 1, "l", "p3r")],
	bunch_weight: [proportionalLever(BUNCH, 3, "size")],
	berry_count: [proportionalLever(BUNCH, 1, "count")],
	spill: [proportionalLever(BUNCH, 1, "unit")],
};

const from = specimenFromPreset("long-conical");
const requested = (aims: Record<string, number>, means: Partial<SolverCallbacks<BunchSpecimen>> = {}) =>
	solve(
		{ table: BUNCH.table, from, levers, aims: Object.entries(aims).map(([key, value]) => ({ measure: key, value })) },
		{ measure, ...means },
	);

describe("solve", () => {
	it("finds the parameter of a measure, and moves what goes with it in proportion", async () => {
		const { specimen, reached, growths } = await requested({ bunch_length: 160 });
		expect(reached).toMatchObject([{ measure: "bunch_length", isReached: true, isAtLimit: false }]);
		expect(specimen.parameters.l).toBeGreaterThan(373);
		expect(specimen.parameters.l).toBeLessThan(377);
		expect(specimen.parameters.p3r / from.parameters.p3r).toBeCloseTo(specimen.parameters.l / from.parameters.l, 3);
		expect(growths).toBeLessThanOrEqual(4);
	});

	it("finds several at once, though one depends on the other's parameter", async () => {
		const { reached, growths } = await requested({ bunch_length: 160, bunch_weight: 400 });
		expect(reached.map(({ isReached }) => isReached)).toEqual([true, true]);
		expect(growths).toBeLessThanOrEqual(8);
	});

	it("sets a parameter that is not set to what is asked", async () => {
		const { specimen, growths } = await requested({ berry_count: 120 });
		expect(from.parameters.count).toBe(0);
		expect(specimen.parameters.count).toBe(120);
		expect(growths).toBe(2);
	});

	it("of a range counts any value within it as met, but searches for the one that was drawn", async () => {
		const coarse = (step: number): SolverCallbacks<BunchSpecimen> => ({
			measure: async (specimen) => (await measure(specimen)).map((value) => step * Math.round(value / step)),
		});
		const aims = [{ measure: "bunch_length", value: 147, within: [130, 170] as const }];
		const question = { table: BUNCH.table, from, levers, aims };
		const { reached: near } = await solve(question, { measure });
		expect([near[0].isReached, Math.abs(near[0].measured - 147) < 0.6]).toEqual([true, true]);
		const { reached: far } = await solve(question, coarse(20));
		expect([far[0].isReached, far[0].measured]).toEqual([true, 140]);
		expect(reachedInWords(far[0])).toBe("Bunch length: 140 mm reached, within 130 mm to 170 mm");
		const { reached: none } = await solve({ ...question, aims: [{ ...aims[0], within: [145, 149] }] }, coarse(20));
		expect([none[0].isReached, none[0].measured]).toEqual([false, 140]);
	});

	it("stays within the table's limits, and says that they are in the way", async () => {
		const { specimen, reached } = await requested({ bunch_length: 500 });
		expect(specimen.parameters.l).toBe(580);
		expect(reached).toMatchObject([{ isReached: false, isAtLimit: true }]);
		expect(reachedInWords(reached[0])).toBe(
			"Bunch length: wanted 500 mm, got 242 mm (the settings are at their limit)",
		);
	});

	it("goes on with the next lever where one comes to its end", async () => {
		const two = { ...levers, bunch_weight: [proportionalLever(BUNCH, 1, "l"), proportionalLever(BUNCH, 3, "size")] };
		const aims = [{ measure: "bunch_weight", value: 900 }];
		const { specimen, reached } = await solve({ table: BUNCH.table, from, levers: two, aims }, { measure });
		expect(reached).toMatchObject([{ isReached: true }]);
		expect(specimen.parameters.l).toBe(580);
		expect(specimen.parameters.size).toBeGreaterThan(from.parameters.size);
	});

	it("takes one growth for what is there already, and none but that changes", async () => {
		const { specimen, growths } = await requested({ bunch_length: 0.4 * from.parameters.l + 10 });
		expect(growths).toBe(1);
		expect(specimen).toBe(from);
	});

	it("ends after so many growths at the most, with the best of them, however the plant behaves", async () => {
		let calls = 0;
		const progress = vi.fn();
		const wild = async (specimen: BunchSpecimen) => {
			const values = await measure(specimen);
			values[place("bunch_length")] += 40 * Math.sin(calls++ * 12.9);
			values[place("bunch_weight")] *= 1 + 0.5 * Math.cos(calls * 7.7);
			return values;
		};
		const { growths } = await requested({ bunch_length: 160, bunch_weight: 300 }, { measure: wild, progress });
		expect(calls).toBe(growths);
		expect(growths).toBeLessThanOrEqual(MAX_GROWTHS);
		expect(progress.mock.calls.map(([count]) => count)).toEqual(Array.from({ length: growths }, (_, i) => i + 1));
	});

	it("leaves a plant alone that has no such measure", async () => {
		const { specimen, reached } = await requested({ spill: 0.1 });
		expect(specimen).toBe(from);
		expect(reachedInWords(reached[0])).toBe("Overflow: this plant has no such measure");
	});

	it("finds the others where one cannot be had, and says which that is", async () => {
		for (const [lost, words] of [
			["spill", "Overflow: this plant has no such measure"],
			["berry_weight", "Berry weight: wanted 3.00 g, got 2.00 g (no setting affects it)"],
		]) {
			const twoGrams: typeof measure = async (each) =>
				(await measure(each)).fill(2, place("berry_weight"), place("berry_weight") + 1);
			const { specimen, reached, growths } = await requested({ [lost]: 3, bunch_length: 160 }, { measure: twoGrams });
			expect(reached.map(({ isReached }) => isReached)).toEqual([false, true]);
			expect(specimen.parameters.l).toBeCloseTo(375, -1);
			expect(growths).toBeLessThanOrEqual(4);
			expect(reachedInWords(reached[0])).toBe(words);
		}
	});

	it("lets what the growth throws through", async () => {
		const failing = () => Promise.reject(new Error("no room"));
		await expect(requested({ bunch_length: 160 }, { measure: failing })).rejects.toThrow("no room");
	});
});

it("says what changed in the lengths that people read", async () => {
	const { specimen } = await requested({ bunch_length: 160 });
	expect(changesInWords(BUNCH, from, specimen)).toMatch(
		/^Length 220\.7 → 16[12](\.\d)? mm and Right drop [\d.]+ → [\d.]+ mm$/,
	);
	const { l, unit } = from.parameters;
	const same = { ...from, parameters: { ...from.parameters, l: l / 2, unit: 2 * unit } };
	expect(changesInWords(BUNCH, from, same)).toBe("Scale 0.25 → 0.5 mm");
});
