import { describe, expect, it } from "vitest";
import { type BarkKind, barkPicture, barkRelief } from "../../../../web/src/plant/wood/bark_picture";

const KINDS: readonly BarkKind[] = ["furrowed", "paper", "ringed", "fibrous", "smooth", "plated", "banded"];

describe.each(KINDS)("%s bark", (kind) => {
	const [picture, relief] = [barkPicture(kind), barkRelief(kind)];
	const normal = (column: number, row: number) =>
		[0, 1, 2].map((k) => relief.pixels[3 * (relief.width * row + column) + k] / 127.5 - 1);
	const height = (column: number, row: number) => picture.pixels[3 * (picture.width * row + column)];

	it("has a relief of unit normals that look out, made once", () => {
		expect(barkRelief(kind)).toBe(relief);
		for (let at = 0; at < 256; at += 17) {
			const [x, y, z] = normal(at, 255 - at);
			expect(Math.hypot(x, y, z)).toBeCloseTo(1, 1);
			expect(z).toBeGreaterThan(0.1);
		}
	});

	it("leans away from what is higher: red to +u, green up the picture", () => {
		let [agree, tried] = [0, 0];
		for (let row = 1; row < 255; row += 5)
			for (let column = 1; column < 255; column += 5) {
				const [x, y] = normal(column, row);
				const [across, down] = [
					height(column + 1, row) - height(column - 1, row),
					height(column, row + 1) - height(column, row - 1),
				];
				if (Math.abs(across) > 8) [agree, tried] = [agree + (Math.sign(x) === -Math.sign(across) ? 1 : 0), tried + 1];
				if (Math.abs(down) > 8) [agree, tried] = [agree + (Math.sign(y) === Math.sign(down) ? 1 : 0), tried + 1];
			}
		expect(agree).toBe(tried);
	});
});

it("furrows and plates are deep, smooth bark is not", () => {
	const steep = (kind: BarkKind) => {
		const { pixels } = barkRelief(kind);
		let sum = 0;
		for (let at = 2; at < pixels.length; at += 3) sum += 255 - pixels[at];
		return sum / (pixels.length / 3);
	};
	expect(Math.min(steep("furrowed"), steep("plated"))).toBeGreaterThan(4 * steep("smooth"));
});
