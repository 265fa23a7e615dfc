import type { Page } from "@playwright/test";
import type { ForestPicture, Forests } from "../forest/page";
import { expect, test } from "./fixtures";
import { serveViews } from "./views_page";

test.use({ drawn: true });

declare global {
	interface Window {
		/** On the page of tests/forest. */
		forests: Forests;
	}
}

let site: Awaited<ReturnType<typeof serveViews>>;
test.beforeAll(async () => {
	site = await serveViews("forest");
});
test.afterAll(() => site.close());
test.beforeEach(async ({ page }) => {
	await page.goto(site.address);
	await page.waitForFunction(() => "forests" in window);
});

const SIDE = 256;

/** A picture of a forest: whether each pixel shows a tree, and its brightness. */
async function picture(page: Page, options: ForestPicture) {
	const { pixels, counts, problems, calls } = await page.evaluate((wanted) => window.forests.draw(wanted), options);
	expect(problems).toEqual([]);
	const each = Array.from({ length: SIDE * SIDE }, (_, i) => pixels.slice(4 * i, 4 * i + 3));
	const brightness = each.map(([red, green, blue]) => (red + green + blue) / 3);
	const covered = brightness.map((value) => value < 250);
	return { covered, brightness, counts, calls };
}

const count = (list: readonly boolean[]) => list.filter(Boolean).length;
/** Pixels in both pictures as a share of those in any. */
const overlap = (one: readonly boolean[], other: readonly boolean[]) =>
	count(one.map((value, i) => value && other[i])) / count(one.map((value, i) => value || other[i]));
const mean = (values: readonly number[], where: readonly boolean[]) =>
	values.reduce((sum, value, i) => sum + (where[i] ? value : 0), 0) / count(where);

test("a forest draws its trees, each material and level in one call", async ({ page }) => {
	const places = Array.from({ length: 50 }, (_, i) => ({
		tree: 0,
		position: [8 * (i % 10) - 36, 0, -8 * Math.floor(i / 10)] as const,
	}));
	const { covered, counts, calls } = await picture(page, { places, distance: 40, sizes: [0.25] });
	expect(count(covered)).toBeGreaterThan(5000);
	expect(counts[0]).toBeGreaterThan(0);
	expect(counts[1]).toBeGreaterThan(0);
	expect(calls).toBeLessThanOrEqual(4);
});

test("the wind moves the crown of a tree, and not its foot", async ({ page }) => {
	const calm = await picture(page, { wind: 0, seconds: 3 });
	expect((await picture(page, { wind: 0, seconds: 7 })).brightness).toEqual(calm.brightness);
	const blown = await picture(page, { wind: 1, seconds: 3 });
	const rows = Array.from({ length: SIDE }, (_, row) => {
		const at = [...Array(SIDE).keys()].map((column) => SIDE * row + column);
		return at.filter((i) => Math.abs(calm.brightness[i] - blown.brightness[i]) > 20).length;
	});
	const shown = [...Array(SIDE).keys()].filter((row) =>
		calm.covered.slice(SIDE * row, SIDE * (row + 1)).includes(true),
	);
	const [top, foot] = [shown[0], shown[shown.length - 1]];
	const tenth = Math.round(0.1 * (foot - top));
	expect(rows.slice(top, top + 5 * tenth).reduce((sum, value) => sum + value)).toBeGreaterThan(200);
	expect(rows.slice(foot - tenth).reduce((sum, value) => sum + value)).toBeLessThan(10);
});

test("a tree that changes levels has no holes", async ({ page }) => {
	const single = await picture(page, {});
	// Both levels are the same tree here: while they fade, every pixel shows one of them.
	const size = 8 / (2 * Math.tan(Math.PI / 9) * (16 - 0.25 * 9.5));
	const fading = await picture(page, { sizes: [size / 1.1] });
	expect(fading.counts).toEqual([1, 1]);
	expect(overlap(single.covered, fading.covered)).toBeGreaterThan(0.99);
});

for (const [title, above, around] of [
	["the front", 0.15, 0.4],
	["behind", 0.1, 3.4],
	["the side and above", 0.8, 1.7],
] as const) {
	test(`an impostor looks like the tree from ${title}`, async ({ page }) => {
		const view = { above, around, distance: 60, wind: 0 };
		const tree = await picture(page, view);
		const impostor = await picture(page, { ...view, impostor: true });
		expect(impostor.counts.at(-1)).toBe(1);
		expect(overlap(tree.covered, impostor.covered)).toBeGreaterThan(0.75);
		const both = tree.covered.map((value, i) => value && impostor.covered[i]);
		expect(Math.abs(mean(tree.brightness, both) - mean(impostor.brightness, both))).toBeLessThan(25);
	});
}
