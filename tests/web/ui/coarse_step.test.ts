import { describe, expect, it } from "vitest";
import { ROOT_TABLE } from "../../../web/src/models/root/table";
import { TREE_TABLE } from "../../../web/src/models/tree/table";
import { coarseStep } from "../../../web/src/ui/coarse_step";

describe("an arrow key on a slider", () => {
	it("moves ten steps with Shift in both directions, and is left to the browser without", () => {
		expect(coarseStep(0.01, { key: "ArrowUp", shiftKey: true })).toBeCloseTo(0.1);
		expect(coarseStep(5, { key: "ArrowLeft", shiftKey: true })).toBe(-50);
		expect(coarseStep(5, { key: "ArrowLeft", shiftKey: false })).toBeUndefined();
		expect(coarseStep(5, { key: "PageUp", shiftKey: true })).toBeUndefined();
	});

	it.each([
		["tree", TREE_TABLE],
		["root", ROOT_TABLE],
	])("goes by a centimetre along every length of a %s, small as a plant may be", (_, table) => {
		const lengths = table.core.filter(({ unit }) => unit === "m");
		expect(lengths.map(({ key }) => key)).toContain("width");
		expect(lengths.filter(({ step }) => step > 0.01)).toEqual([]);
	});
});
