import { describe, expect, it } from "vitest";
import { trailRecord } from "../../../../web/src/models/particles/record";
import type { TrailPlant } from "../../../../web/src/models/particles/trails";
import { EMPTY_PLANT } from "../../../../web/src/plant/plant";

const plant: TrailPlant = {
	...EMPTY_PLANT,
	counts: { particles: 2, energy: 2, merges: 1, steps: 7, segments: 2, targets: 2 },
	segments: {
		count: 2,
		parent: Int32Array.of(-1, 0),
		tag: Uint32Array.of(0, 0),
		tags: ["vein"],
		ends: Float32Array.of(0, 0, 0, 0, 0.1, 0, 0, 0.1, 0, 0.2, 0.3, 0),
		radii: Float32Array.of(0.01, 0.01, 0.005, 0),
	},
	energy: Float32Array.of(1.5, 1.5),
	born: Uint32Array.of(2, 1),
	targets: Float32Array.of(0, 0, 0, 1, 0, 0.5),
	arrived: Float32Array.of(1.5, 0.5),
};

describe("trailRecord", () => {
	it("records the energy through each segment and the energy that arrived at each target", () => {
		const { counts, segments, targets } = trailRecord(plant);
		expect(segments.records()).toEqual([
			{ parent: -1, kind: "vein", start: [0, 0, 0], end: [0, 0.1, 0], energy: 1.5, radius: 0.01, radiusEnd: 0.01 },
			{ parent: 0, kind: "vein", start: [0, 0.1, 0], end: [0.2, 0.3, 0], energy: 1.5, radius: 0.005, radiusEnd: 0 },
		]);
		expect(targets.records()).toEqual([
			{ x: 0, y: 0, z: 0, energy: 1.5 },
			{ x: 1, y: 0, z: 0.5, energy: 0.5 },
		]);
		expect(counts).toEqual({ ...plant.counts, energy: 2 });
	});
});
