import { describe, expect, it } from "vitest";
import { namesWithRoom } from "../../../web/src/ui/stage_names";

const NAMES = [
	{ start: 0, end: 52 },
	{ start: 40, end: 90 },
	{ start: 120, end: 160 },
	{ start: 150, end: 200 },
];

describe("names of stages below a slider", () => {
	it("are hidden where they would touch an earlier one", () => {
		expect(namesWithRoom(NAMES, -1)).toEqual([true, false, true, false]);
	});

	it("give way to the current one", () => {
		expect(namesWithRoom(NAMES, 1)).toEqual([false, true, true, false]);
		expect(namesWithRoom(NAMES, 3)).toEqual([true, false, false, true]);
	});

	it("are all shown where there is room", () => {
		const wide = NAMES.map(({ start, end }) => ({ start: 3 * start, end: 3 * start + end - start }));
		expect(namesWithRoom(wide, 0)).toEqual([true, true, true, true]);
	});
});
