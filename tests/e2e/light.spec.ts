import { expect, test } from "./fixtures";
import { brightness, drawn, openViews, type Seen, serveViews, whereTheyDiffer } from "./views_page";

test.use({ drawn: true });

/**
 * Properties of the view's light, tested by means over small pictures without stored references, with wide tolerances.
 */
let host: Awaited<ReturnType<typeof serveViews>>;
test.beforeAll(async () => {
	host = await serveViews();
});
test.afterAll(() => host.close());
test.beforeEach(({ page }) => openViews(page, host.address));

/**
 * Dark grapes on a light background: pixels darker than any background, even in shadow, show the plant. A stalk above
 * would cast a shadow.
 */
const DARK = "?v=2&preset=short-conical&peduncle=0";
const isPlant = (pixel: readonly number[]) => Math.max(...pixel) < 150;
const plantOf = (seen: Seen, where = (_x: number, _y: number) => true) =>
	brightness(seen, (x, y, pixel) => isPlant(pixel) && where(x, y));

test("the key light comes from the upper left", async ({ page }) => {
	const seen = await drawn(page, { query: DARK });
	const left = plantOf(seen, (x) => x < 0.5);
	expect(left).toBeGreaterThan(1.15 * plantOf(seen, (x) => x > 0.5));
	expect(plantOf(seen, (x, y) => x < 0.5 && y < 0.5)).toBeGreaterThan(plantOf(seen, (x, y) => x < 0.5 && y > 0.5));
});

test("berries stand in each other's light", { tag: "@long" }, async ({ page }) => {
	// A black bunch shows the berries' positions, a pale one their light.
	const black = await drawn(page, { query: `${DARK}&bloom=0&glow=0&skin=000000&unripe=000000&stem=000000` });
	const rows = black.pixels;
	const isBunch = (x: number, y: number) => isPlant(rows[Math.floor(y * rows.length)][Math.floor(x * rows[0].length)]);
	const pale = `${DARK}&bloom=0&glow=0&uneven=0&lenticels=0&skin=c0b090&unripe=c0b090`;
	const seen = await drawn(page, { query: pale, theme: "dark" });
	// The key light comes from the left: at the right it falls on others first. If nothing stood in its way, the right side
	// would have nine tenths of the mean or more.
	const [whole, right] = [brightness(seen, isBunch), brightness(seen, (x, y) => x > 0.5 && isBunch(x, y))];
	expect(right).toBeLessThan(0.86 * whole);
	expect(right).toBeGreaterThan(0.5 * whole);
});

test("the bunch's shadow lies on the paper to its right, in both themes", { tag: "@long" }, async ({ page }) => {
	const paper = (seen: Seen, from: number, to: number) =>
		brightness(seen, (x, y) => x > from && x < to && y > 0.35 && y < 0.65);
	for (const theme of ["light", "dark"] as const) {
		const seen = await drawn(page, { query: DARK, theme });
		expect(paper(seen, 0.7, 0.8)).toBeLessThan(0.95 * paper(seen, 0.2, 0.3));
	}
});

test("wax pales dark skins", { tag: "@long" }, async ({ page }) => {
	const [clean, waxed] = [
		await drawn(page, { query: `${DARK}&bloom=0` }),
		await drawn(page, { query: `${DARK}&bloom=1` }),
	];
	expect(plantOf(waxed)).toBeGreaterThan(1.6 * plantOf(clean));
});

test("stems that stand bare are brighter than among berries, and nothing is left of the berries' shadow", {
	tag: "@long",
}, async ({ page }) => {
	// Pale stems on dark paper.
	const query = `${DARK}&stem=e0e0a0&skin=101010&unripe=101010&bloom=0&density=3`;
	const isStem = ([red, , blue]: readonly number[]) => red > 1.35 * blue && red > 50;
	const stems = (seen: Seen) => brightness(seen, (_x, _y, pixel) => isStem(pixel));
	const among = await drawn(page, { query, theme: "dark" });
	const bare = await drawn(page, { query, theme: "dark", mode: "stems" });
	// If the berries that are not shown still stood in the light, it would be 1.2 times.
	expect(stems(bare)).toBeGreaterThan(1.4 * stems(among));
});

test("a turn to the right takes the berry in front to the right, one to the left to the left", {
	tag: "@long",
}, async ({ page }) => {
	const query = `${DARK}&count=40`;
	const marked = await page.evaluate((options) => {
		const { spheres, count } = window.views.grow(options).grown.berries;
		// From where the view opens: 24° to the right.
		const towards = (i: number) => spheres[4 * i] * Math.sin(0.42) + spheres[4 * i + 2] * Math.cos(0.42);
		return Array.from({ length: count }, (_, i) => i).sort((a, b) => towards(b) - towards(a))[0];
	}, query);
	const at = async (turn: number) =>
		whereTheyDiffer(await drawn(page, { query, turn }), await drawn(page, { query, turn, marked })).x;
	const [left, middle, right] = [await at(-0.4), await at(0), await at(0.4)];
	expect(middle).toBeGreaterThan(left + 0.02);
	expect(right).toBeGreaterThan(middle + 0.02);
});

test("a matt card is as bright as the lamps' own numbers make it", { tag: "@long" }, async ({ page }) => {
	for (const theme of ["light", "dark"] as const) {
		const { seen, expectedLight } = await page.evaluate(async (which) => {
			const { canvas, card, pixels, Viewer } = window.views;
			const viewer = new Viewer<undefined, undefined>(canvas(64, 64), { still: true, theme: which });
			const lit = card(viewer, 0.3, which);
			const { data, width } = await pixels(await viewer.snapshot(64, 64));
			viewer.dispose();
			const at = 4 * (32 * width + 32);
			return { seen: [...data.subarray(at, at + 3)], expectedLight: lit };
		}, theme);
		// Below the tone mapping's shoulder, 0.04 off; then sRGB.
		const expected = expectedLight.map((light) => 255 * (1.055 * (light - 0.04) ** (1 / 2.4) - 0.055));
		for (const [k, value] of expected.entries()) expect(Math.abs(seen[k] / value - 1)).toBeLessThan(0.05);
	}
});

test("a plant that is cut out has nothing behind it, its own colours, and the paper is back after", {
	tag: "@long",
}, async ({ page }) => {
	const { corner, berry, onPaper, after, refused, middle } = await page.evaluate(async () => {
		const { view, pixels } = window.views;
		const viewer = view("?v=2&preset=merlot", [96, 96]);
		const all = async (picture: Blob) => (await pixels(picture)).data;
		const before = await all(await viewer.snapshot(96, 96));
		const cut = await all(await viewer.cutOut(96, 96));
		const room = OffscreenCanvas.prototype.getContext;
		OffscreenCanvas.prototype.getContext = () => null;
		const refused = await viewer.cutOut(64, 32).catch(String);
		OffscreenCanvas.prototype.getContext = room;
		// In the middle of the view as it was before: a size that is left behind has it elsewhere.
		const { x, y } = viewer.project(
			viewer.camera.position.clone().set(0, 0, -1).applyMatrix4(viewer.camera.matrixWorld),
		);
		const again = await all(await viewer.snapshot(96, 96));
		viewer.dispose();
		const opaque = Array.from({ length: 96 * 96 }, (_, i) => 4 * i).filter((at) => cut[at + 3] === 255);
		const at = opaque[Math.floor(opaque.length / 2)];
		const of = (data: Uint8ClampedArray, from: number) => [...data.subarray(from, from + 4)];
		return {
			corner: of(cut, 0),
			berry: of(cut, at),
			onPaper: of(before, at),
			after: [of(before, 0), of(again, 0)],
			refused,
			middle: [x, y],
		};
	});
	expect(refused).toContain("no room for 64 × 32 pixels");
	for (const at of middle) expect(at).toBeCloseTo(48, 3);
	expect(corner[3]).toBe(0);
	for (const [k, value] of berry.entries()) expect(Math.abs(value - onPaper[k])).toBeLessThan(3);
	expect(after[1]).toEqual(after[0]);
	expect(after[0][3]).toBe(255);
});
