import { describe, expect, it } from "vitest";
import { bounced, repeatedColour, shaded } from "../../../web/src/plant/shade";

describe("bounced", () => {
	it.each([0.02, 0.3, 0.8])("leaves an open sky open and a hidden one dark, for albedo %f", (albedo) => {
		expect(bounced(1, albedo)).toBeCloseTo(1, 2);
		expect(bounced(0, albedo)).toBe(0);
	});

	it("is at least what is visible, and brighter in between the brighter the surface", () => {
		for (let visible = 0.1; visible < 0.95; visible += 0.1) {
			expect(bounced(visible, 0.05)).toBeGreaterThanOrEqual(visible);
			expect(bounced(visible, 0.8)).toBeGreaterThan(bounced(visible, 0.3) + 0.004);
		}
		// Jimenez et al. 2016, figure 8: half open and white, four fifths of the light.
		expect(bounced(0.5, 0.9)).toBeGreaterThan(0.7);
		expect(bounced(0.5, 0.9)).toBeLessThan(0.9);
	});
});

describe("shaded", () => {
	const colours = Float32Array.from([0.8, 0.4, 0.1, 0.8, 0.4, 0.1, 0.8, 0.4, 0.1]);

	it("dims each vertex by its own sky, pale channels less", () => {
		const dimmed = shaded(colours, Uint8Array.from([255, 128, 0]));
		expect([...dimmed.subarray(0, 3)]).toEqual([...colours.subarray(0, 3)]);
		expect([...dimmed.subarray(6, 9)]).toEqual([0, 0, 0]);
		const [red, , blue] = [3, 4, 5].map((at) => dimmed[at] / colours[at]);
		expect(blue).toBeCloseTo(Math.max(128 / 255, bounced(128 / 255, 0.1)), 5);
		expect(red).toBeGreaterThan(blue + 0.1);
		expect(red).toBeLessThan(1);
	});

	it("never brightens", () => {
		const all = repeatedColour([0.99, 0.5, 0.01], 256);
		const dimmed = shaded(
			all,
			Uint8Array.from({ length: 256 }, (_, i) => i),
		);
		dimmed.forEach((value, i) => {
			expect(value).toBeLessThanOrEqual(all[i]);
		});
	});
});
