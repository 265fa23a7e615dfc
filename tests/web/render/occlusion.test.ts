import { describe, expect, it } from "vitest";
import { lampHidden } from "../../../web/src/render/occlusion";

describe("lampHidden", () => {
	it("is complete in the middle of the shadow, and zero beside, behind and beyond the penumbra", () => {
		expect(lampHidden(1, 0, 2, 0.1)).toBe(1);
		expect(lampHidden(1, 0, -2, 0.1)).toBe(0);
		expect(lampHidden(1, 1.3, 2, 0.1)).toBe(0);
		expect(lampHidden(1, 1, 2, 0.1)).toBeCloseTo(0.5, 9);
	});

	it("is never complete for a sphere smaller than the apparent lamp", () => {
		expect(lampHidden(1, 0, 20, 0.1)).toBeLessThanOrEqual(0.25);
		expect(lampHidden(1, 0, 20, 0.1)).toBeGreaterThan(0.15);
	});
});
