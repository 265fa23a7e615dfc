import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { entryOf, type NumberEntry } from "../../../web/src/specimen/table";
import { nextStage, STAGES, stageOf } from "../../../web/src/studio/age";

const { min, max } = entryOf("age") as NumberEntry;
const anyAge = fc.double({ min, max, noNaN: true });

describe("stages", () => {
	it("spans the parameter's range", () => {
		expect([STAGES[0].at, STAGES.at(-1)?.at]).toEqual([min, max]);
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
	])("calls %d %s", (age, name) => expect(stageOf(age).name).toBe(name));

	it("goes on and back to neighbours only, and stays at the ends", () => {
		fc.assert(
			fc.property(anyAge, (age) => {
				const on = nextStage(age, 1).at;
				const back = nextStage(age, -1).at;
				expect(on > age || on === max).toBe(true);
				expect(back < age || back === min).toBe(true);
				expect(STAGES.filter(({ at }) => at > age && at < on)).toEqual([]);
				expect(STAGES.filter(({ at }) => at < age && at > back)).toEqual([]);
			}),
		);
	});
});
