import { describe, expect, it } from "vitest";
import { type Berries, TRAITS } from "../../../../../web/src/models/bunch/bunch_plant";
import { fromTheTop, placeInWords, roundedWidth } from "../../../../../web/src/models/bunch/ui/berry_places";

/** Berries at these places in centimetres, of these widths in millimetres. */
function berriesAt(...places: [x: number, y: number, z: number, width: number][]): Berries {
	const rest = new Array<number>(TRAITS.length - 1).fill(0);
	return {
		count: places.length,
		spheres: Float32Array.from(places.flatMap(([x, y, z, width]) => [x / 100, y / 100, z / 100, width / 2000])),
		directions: new Float32Array(3 * places.length),
		parent: new Int32Array(places.length),
		ids: Uint32Array.from(places.keys()),
		traits: Float32Array.from(places.flatMap(([, , , width]) => [width / 1000, ...rest])),
	};
}

const berries = berriesAt([0, -9, 5, 18], [-4, -1, 4, 8.4], [5, -5, 0, 12], [0, -12, -5, 20], [0.5, -6, 0.2, 20]);

describe("berry places", () => {
	it("goes through the berries from the top down", () => {
		expect(fromTheTop(berries)).toEqual([1, 2, 4, 0, 3]);
	});

	it.each([
		[0, "at the tip, front"],
		[1, "at the top, front left"],
		[2, "in the middle, right"],
		[3, "at the tip, back"],
		[4, "in the middle, inside"],
	])("describes where berry %d is", (berry, words) => expect(placeInWords(berries, berry)).toBe(words));

	it("has words for a bunch of one", () => {
		expect(placeInWords(berriesAt([0, -1, 0, 10]), 0)).toMatch(/^at the top, /);
	});

	it("gives small widths with more digits", () => {
		expect(roundedWidth(berries, 0)).toBe(18);
		expect(roundedWidth(berries, 1)).toBe(8.4);
	});
});
