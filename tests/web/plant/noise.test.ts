import { describe, expect, it } from "vitest";
import { hashFraction, noise } from "../../../web/src/plant/noise";

describe("hashFraction", () => {
	it("is even, and another for another stream", () => {
		let sum = 0;
		const bins = new Array(10).fill(0);
		for (let i = 0; i < 5000; i++) {
			const value = hashFraction(i, 2);
			sum += value;
			bins[Math.floor(value * 10)]++;
		}
		expect(sum / 5000).toBeCloseTo(0.5, 1);
		for (const bin of bins) expect(Math.abs(bin - 500)).toBeLessThan(110);
		expect(hashFraction(7, 1)).not.toBe(hashFraction(7, 2));
	});
});

describe("noise", () => {
	const places = Array.from({ length: 3000 }, (_, i) => [0.37 * i - 500, 0.11 * i - 40, 0.053 * i] as const);

	it("keeps within 0 … 1 and is even about the middle", () => {
		const values = places.map((at) => noise(...at));
		expect(Math.min(...values)).toBeGreaterThanOrEqual(0);
		expect(Math.max(...values)).toBeLessThanOrEqual(1);
		expect(values.reduce((sum, each) => sum + each, 0) / values.length).toBeCloseTo(0.5, 1);
		expect(Math.max(...values) - Math.min(...values)).toBeGreaterThan(0.8);
	});

	it("is smooth: within a cell, across its borders and below nought", () => {
		for (const [x, y, z] of places) {
			expect(Math.abs(noise(x + 0.001, y, z) - noise(x, y, z))).toBeLessThan(0.002);
		}
		expect(noise(-2 - 1e-9, 0.5, 0.5)).toBeCloseTo(noise(-2, 0.5, 0.5), 6);
	});

	it("is the shaders' own: their hash at a corner, worked out with whole numbers", () => {
		const mask = 0xffffffffn;
		const hash = (x: bigint, y: bigint, z: bigint) => {
			const [a, b, c] = [(x * 0x9e3779b1n) & mask, (y * 0x85ebca6bn) & mask, (z * 0xc2b2ae35n) & mask];
			const mixed = a ^ (b >> 7n) ^ ((b << 9n) & mask) ^ (c >> 13n) ^ ((c << 3n) & mask);
			let h = (mixed * 0x27d4eb2dn) & mask;
			h = ((h ^ (h >> 15n)) * 0x2c1b3c6dn) & mask;
			return Number(h >> 16n) / 65535;
		};
		for (const [x, y, z] of [
			[0, 0, 0],
			[3, -7, 12],
			[-100, 41, -5],
		]) {
			expect(noise(x, y, z)).toBeCloseTo(hash(BigInt(x) & mask, BigInt(y) & mask, BigInt(z) & mask), 12);
		}
	});
});
