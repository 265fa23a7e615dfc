import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { lampHidden, skyHidden } from "../../../web/src/scene/occlusion";
import { evenly } from "../evenly";

/** ∫ over the half space of max(0, cos) / π inside the cone of half angle α about a direction γ from the normal, by sampling. */
function sampledCone(alpha: number, gamma: number): number {
	const rings = 400;
	const turns = 400;
	let sum = 0;
	for (let i = 0; i < rings; i++) {
		const theta = (alpha * (i + 0.5)) / rings;
		for (let k = 0; k < turns; k++) {
			const phi = (2 * Math.PI * (k + 0.5)) / turns;
			const cosine = Math.cos(gamma) * Math.cos(theta) + Math.sin(gamma) * Math.sin(theta) * Math.cos(phi);
			sum += Math.max(0, cosine) * Math.sin(theta);
		}
	}
	return (sum * (alpha / rings) * ((2 * Math.PI) / turns)) / Math.PI;
}

describe("skyHidden", () => {
	it.each([
		[0.3, 0],
		[0.5, 0.6],
		[0.9, 0.5],
	])("is exact for a sphere above the horizon (α %f, γ %f)", (alpha, gamma) => {
		expect(skyHidden(Math.sin(alpha), Math.cos(gamma))).toBeCloseTo(sampledCone(alpha, gamma), 4);
	});

	it.each([
		[0.4, Math.PI / 2],
		[0.8, Math.PI / 2],
		[0.6, 1.3],
		[0.6, 1.8],
	])("stays close while the sphere sets (α %f, γ %f)", (alpha, gamma) => {
		expect(Math.abs(skyHidden(Math.sin(alpha), Math.cos(gamma)) - sampledCone(alpha, gamma))).toBeLessThan(0.06);
	});

	it("lies within 0 … 1, is continuous and grows with size and height", () => {
		const unit = evenly(0.01, 0.999);
		const cosine = evenly(-1, 1);
		fc.assert(
			fc.property(unit, cosine, (sine, c) => {
				const hidden = skyHidden(sine, c);
				expect(hidden).toBeGreaterThanOrEqual(0);
				expect(hidden).toBeLessThanOrEqual(1);
				expect(skyHidden(sine, Math.min(1, c + 1e-6))).toBeGreaterThanOrEqual(hidden);
				expect(skyHidden(sine, Math.min(1, c + 1e-6)) - hidden).toBeLessThan(1e-5);
				expect(skyHidden(Math.min(1, sine * 1.001), c)).toBeGreaterThanOrEqual(hidden - 1e-12);
			}),
		);
	});
});

describe("lampHidden", () => {
	it("is whole in the middle of the shadow and nothing beside, behind or beyond the penumbra", () => {
		expect(lampHidden(1, 0, 2, 0.1)).toBe(1);
		expect(lampHidden(1, 0, -2, 0.1)).toBe(0);
		expect(lampHidden(1, 1.3, 2, 0.1)).toBe(0);
		expect(lampHidden(1, 1, 2, 0.1)).toBeCloseTo(0.5, 9);
	});

	it("is never whole for a sphere smaller than the lamp looks", () => {
		expect(lampHidden(1, 0, 20, 0.1)).toBeLessThanOrEqual(0.25);
		expect(lampHidden(1, 0, 20, 0.1)).toBeGreaterThan(0.15);
	});
});
