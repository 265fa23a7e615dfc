import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { LIFE } from "../../../web/src/models/bunch/ui/age";
import type { NumberEntry } from "../../../web/src/specimen/table";
import { nextStage, nextStep, stageOf } from "../../../web/src/ui/life";
import { entryOf } from "../bunch";

const { min, max } = entryOf(LIFE.parameter) as NumberEntry;
const { stages } = LIFE;
const anyAge = fc.double({ min, max, noNaN: true });

describe("stages", () => {
	it("span the parameter's range", () => {
		expect([stages[0].at, stages.at(-1)?.at]).toEqual([min, max]);
	});

	it.each([
		[0, "Flowering"],
		[9.9, "Flowering"],
		[10, "Fruit set"],
		[45, "Green"],
		[60, "Colouring"],
		[100, "Ripe"],
		[105, "Ripe"],
		[118, "Shrivelled"],
		[125, "Shrivelled"],
	])("call %d %s", (age, name) => expect(stageOf(LIFE, age).name).toBe(name));

	it("lead to neighbours only, and stop at the ends", () => {
		fc.assert(
			fc.property(anyAge, (age) => {
				const on = nextStage(LIFE, age, 1).at;
				const back = nextStage(LIFE, age, -1).at;
				expect(on > age || on === max).toBe(true);
				expect(back < age || back === min).toBe(true);
				expect(stages.filter(({ at }) => at > age && at < on)).toEqual([]);
				expect(stages.filter(({ at }) => at < age && at > back)).toEqual([]);
			}),
		);
	});
});

describe("the next step", () => {
	it("visits every step of a life, then its end, then its beginning", () => {
		const steps = fc.integer({ min: 1, max: 3000 });
		fc.assert(
			fc.property(steps, (count) => {
				const seen: number[] = [];
				for (let age = 0; age < LIFE.end && seen.length <= count; ) {
					age = nextStep(LIFE, age, count);
					// As the core reads it: single precision.
					seen.push(Math.floor(Math.fround(Math.fround(age) / 100) * count));
				}
				expect(seen).toEqual(Array.from({ length: count }, (_, i) => i + 1));
			}),
			{ numRuns: 60 },
		);
		expect(nextStep(LIFE, LIFE.end, 40)).toBe(stages[0].at);
	});
});
