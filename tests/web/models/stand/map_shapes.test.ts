import { describe, expect, it } from "vitest";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { kindShapes, MAP_SHAPES } from "../../../../web/src/models/stand/ui/map_shapes";

const standOf = (...names: string[]) => ({ kinds: names.map((name) => ({ name })) }) as unknown as StandPlant;

describe("shapes of the map", () => {
	it("differ between the first twelve kinds, and are shared by kinds of the same name", () => {
		const shapes = kindShapes(standOf("a", "b", "a", ..."cdefghijkl"));
		expect(shapes[2]).toBe(shapes[0]);
		expect(new Set(shapes).size).toBe(12);
	});

	it("begin again after the last", () => {
		const shapes = kindShapes(standOf(..."abcdefghijklm"));
		expect(shapes[12]).toBe(shapes[0]);
	});

	it("are paths around their place, different from each other", () => {
		const drawn = MAP_SHAPES.map((shape) => shape(3, -2, 0.5));
		expect(new Set(drawn).size).toBe(MAP_SHAPES.length);
		expect(drawn[0]).toBe("M3 -2m-0.5 0a0.5 0.5 0 1 0 1 0a0.5 0.5 0 1 0 -1 0");
		expect(drawn[2]).toBe("M2.555 -2.445L3.445 -2.445L3.445 -1.555L2.555 -1.555Z");
		// The hole of a hollow shape is drawn the other way round.
		expect(drawn[6]).toBe(`${drawn[0]}M3 -2m-0.275 0a0.275 0.275 0 1 1 0.55 0a0.275 0.275 0 1 1 -0.55 0`);
		expect(drawn[8]).toBe(`${drawn[2]}M2.755 -1.755L3.245 -1.755L3.245 -2.245L2.755 -2.245Z`);
		for (const path of drawn.filter((each) => !each.includes("a"))) {
			const xs = [...path.matchAll(/[ML](-?[\d.]+) (-?[\d.]+)/g)].map(([, x]) => Number(x));
			expect((Math.max(...xs) + Math.min(...xs)) / 2).toBeCloseTo(3, 2);
		}
	});
});
