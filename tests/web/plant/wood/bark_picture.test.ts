/** Laws of the pictures of bark: they repeat, look like their kinds, and have real sizes. */
import { describe, expect, it } from "vitest";
import { linear } from "../../../../web/src/plant/colour";
import { HEIGHT, TILE, WIDTH } from "../../../../web/src/plant/wood/bark_kinds";
import { type BarkKind, barkPictures } from "../../../../web/src/plant/wood/bark_picture";

const KINDS: readonly BarkKind[] = ["furrowed", "paper", "ringed", "fibrous", "smooth", "plated", "banded"];

/** Returns the sRGB lightness of each pixel, 0 … 1. */
function lightness(kind: BarkKind): Float64Array {
	const { pixels } = barkPictures(kind).textures.colour;
	return Float64Array.from(
		{ length: pixels.length / 3 },
		(_, i) => (0.2126 * pixels[3 * i] + 0.7152 * pixels[3 * i + 1] + 0.0722 * pixels[3 * i + 2]) / 255,
	);
}

function mean(values: Float64Array): number {
	return values.reduce((sum, each) => sum + each, 0) / values.length;
}

/** Returns the standard deviation over the mean. */
function variation(values: Float64Array): number {
	const middle = mean(values);
	return Math.sqrt(mean(values.map((each) => (each - middle) ** 2))) / middle;
}

/** Returns the correlation of pixels with those so many columns and rows away. */
function correlation(values: Float64Array, columns: number, rows: number): number {
	const middle = mean(values);
	let [product, square] = [0, 0];
	for (let row = 0; row < HEIGHT; row++)
		for (let column = 0; column < WIDTH; column++) {
			const here = values[row * WIDTH + column] - middle;
			product += here * (values[((row + rows) % HEIGHT) * WIDTH + ((column + columns) % WIDTH)] - middle);
			square += here * here;
		}
	return product / square;
}

/** Returns the mean difference of the pixels of two columns. */
function columnDifference(values: Float64Array, one: number, other: number): number {
	let sum = 0;
	for (let row = 0; row < HEIGHT; row++)
		sum += Math.abs(values[row * WIDTH + (one % WIDTH)] - values[row * WIDTH + (other % WIDTH)]);
	return sum / HEIGHT;
}

it("pictures have 512 pixels a metre", () => {
	expect([WIDTH / TILE[0], HEIGHT / TILE[1]]).toEqual([512, 512]);
});

describe.each(KINDS)("%s bark", (kind) => {
	const { textures, mean: average, roughness } = barkPictures(kind);
	const light = lightness(kind);

	it("is painted once", () => {
		expect(barkPictures(kind).textures).toBe(textures);
	});

	it("goes on at any quarter of its width, and where it ends, as smoothly as inside", () => {
		const quarter = WIDTH / 4;
		const inside = Array.from({ length: WIDTH - 1 }, (_, k) => columnDifference(light, k, k + 1));
		const usual = Math.max(...inside);
		for (let from = 0; from < 4; from++)
			for (let to = 0; to < 4; to++)
				expect(columnDifference(light, from * quarter + quarter - 1, to * quarter)).toBeLessThanOrEqual(1.2 * usual);
		const rowDifference = (one: number, other: number) => {
			let sum = 0;
			for (let k = 0; k < WIDTH; k++) sum += Math.abs(light[one * WIDTH + k] - light[other * WIDTH + k]);
			return sum;
		};
		const rows = Array.from({ length: HEIGHT - 1 }, (_, k) => rowDifference(k, k + 1));
		expect(rowDifference(HEIGHT - 1, 0)).toBeLessThanOrEqual(Math.max(...rows));
	});

	it("has unit normals that look out", () => {
		const { pixels } = textures.normal;
		for (let at = 0; at < pixels.length; at += 3 * 97) {
			const [x, y, z] = [0, 1, 2].map((k) => pixels[at + k] / 127.5 - 1);
			expect(Math.hypot(x, y, z)).toBeCloseTo(1, 1);
			expect(z).toBeGreaterThan(0.1);
		}
	});

	it("has the mean colour and roughness that its vertices are divided by", () => {
		const sums = [0, 0, 0];
		const { pixels } = textures.colour;
		for (let at = 0; at < pixels.length; at += 3)
			for (let k = 0; k < 3; k++) sums[k] += linear(pixels[at + k].toString(16).padStart(2, "0").repeat(3))[0];
		for (let k = 0; k < 3; k++) expect(average[k]).toBeCloseTo(sums[k] / (pixels.length / 3), 2);
		const { pixels: surface } = textures.surface;
		let rough = 0;
		for (let at = 1; at < surface.length; at += 3) rough += surface[at] / 255;
		expect(roughness).toBeCloseTo(rough / (surface.length / 3), 2);
	});
});

it("birch is pale, with marks that are longer across than along", () => {
	const light = lightness("paper");
	expect(mean(light)).toBeGreaterThan(0.72);
	expect(correlation(light, 10, 0)).toBeGreaterThan(3 * Math.max(0.01, correlation(light, 0, 10)));
});

it("beech is even", () => {
	expect(variation(lightness("smooth"))).toBeLessThan(0.12);
	expect(variation(lightness("furrowed"))).toBeGreaterThan(0.25);
});

it("furrows and fibres run along; a cherry's lenticels and a carrot's creases run across", () => {
	for (const kind of ["furrowed", "fibrous", "plated"] as const)
		expect(correlation(lightness(kind), 0, 12)).toBeGreaterThan(correlation(lightness(kind), 12, 0));
	for (const kind of ["ringed", "banded", "paper"] as const)
		expect(correlation(lightness(kind), 8, 0)).toBeGreaterThan(correlation(lightness(kind), 0, 8));
});

it("furrows of oak are 20 to 80 mm apart and as dark as real ones", () => {
	const light = lightness("furrowed");
	const limit = 0.72 * mean(light);
	let furrows = 0;
	for (let row = 0; row < HEIGHT; row += 8)
		for (let column = 0; column < WIDTH; column++) {
			const at = (k: number) => light[row * WIDTH + (k % WIDTH)];
			if (at(column) >= limit && at(column + 1) < limit) furrows++;
		}
	const apart = (1000 * TILE[0] * (HEIGHT / 8)) / furrows;
	expect(apart).toBeGreaterThan(20);
	expect(apart).toBeLessThan(80);
});

it("is dark in the depth: occlusion follows the furrows", () => {
	const { pixels } = barkPictures("furrowed").textures.surface;
	const light = lightness("furrowed");
	let [covered, open] = [0, 0];
	let [coveredCount, openCount] = [0, 0];
	for (let row = 0; row < HEIGHT / 2; row++)
		for (let column = 0; column < WIDTH / 2; column++) {
			const occlusion = pixels[3 * ((row * WIDTH) / 2 + column)];
			const here = light[2 * row * WIDTH + 2 * column];
			if (occlusion < 150) [covered, coveredCount] = [covered + here, coveredCount + 1];
			if (occlusion > 240) [open, openCount] = [open + here, openCount + 1];
		}
	expect(covered / coveredCount).toBeLessThan(0.7 * (open / openCount));
});

it("furrows and plates are deep, smooth bark is not", () => {
	const steep = (kind: BarkKind) => {
		const { pixels } = barkPictures(kind).textures.normal;
		let sum = 0;
		for (let at = 2; at < pixels.length; at += 3) sum += 255 - pixels[at];
		return sum / (pixels.length / 3);
	};
	expect(Math.min(steep("furrowed"), steep("plated"))).toBeGreaterThan(4 * steep("smooth"));
});
