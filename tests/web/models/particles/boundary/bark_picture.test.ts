import { describe, expect, it } from "vitest";
import { type BarkKind, barkPicture } from "../../../../../web/src/plant/wood/bark_picture";

const KINDS: readonly BarkKind[] = ["furrowed", "paper", "ringed", "fibrous"];

describe("a picture of bark", () => {
	it.each(KINDS)("goes on where it ends, without a seam (%s)", (kind) => {
		const { width, height, pixels } = barkPicture(kind);
		const at = (x: number, y: number) => pixels[3 * (y * width + x)];
		const step = (across: number, along: number) => {
			let sum = 0;
			for (let k = 0; k < width; k++) {
				sum +=
					along < 0
						? Math.abs(at(across, k) - at((across + 1) % width, k))
						: Math.abs(at(k, along) - at(k, (along + 1) % height));
			}
			return sum / width;
		};
		const inside = (along: boolean) => {
			const steps = Array.from({ length: width - 1 }, (_, k) => (along ? step(0, k) : step(k, -1)));
			return Math.max(...steps);
		};
		expect(step(width - 1, -1)).toBeLessThanOrEqual(inside(false));
		expect(step(0, height - 1)).toBeLessThanOrEqual(inside(true));
	});

	it("runs along where it is furrowed, and across where it is ringed", () => {
		const rough = (kind: BarkKind, dx: number, dy: number) => {
			const { width, pixels } = barkPicture(kind);
			let sum = 0;
			for (let y = 0; y < width - 4; y++)
				for (let x = 0; x < width - 4; x++)
					sum += Math.abs(pixels[3 * (y * width + x)] - pixels[3 * ((y + dy) * width + x + dx)]);
			return sum;
		};
		for (const kind of ["furrowed", "fibrous"] as const)
			expect(rough(kind, 3, 0)).toBeGreaterThan(1.3 * rough(kind, 0, 3));
		for (const kind of ["ringed", "paper"] as const) expect(rough(kind, 0, 3)).toBeGreaterThan(1.3 * rough(kind, 3, 0));
	});
});
