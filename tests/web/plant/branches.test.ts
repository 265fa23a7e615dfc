import { describe, expect, it } from "vitest";
import { branchBases } from "../../../web/src/plant/branches";
import { EMPTY_PLANT } from "../../../web/src/plant/plant";

describe("branchBases", () => {
	it("gives all segments beyond the limbs the first thin one of their branch, in any order of segments", () => {
		// 5 is the trunk; 0 a limb on it; 1 … 2 one branch of the limb, 3 another one; 4 a twig of 2.
		const segments = {
			...EMPTY_PLANT.segments,
			count: 6,
			parent: Int32Array.of(5, 0, 1, 0, 2, -1),
			radii: Float32Array.from([0.5, 0.1, 0.08, 0.1, 0.02, 1].flatMap((radius) => [radius, radius])),
		};
		expect([...branchBases(segments)]).toEqual([-1, 1, 1, 3, 1, -1]);
	});
});
