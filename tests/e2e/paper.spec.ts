import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test.use({ drawn: true });

test("a leaf's shadow lies on the paper to its right, and no edge shows where it ends", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&model=leaf&preset=lime");
	const view = page.getByRole("application", { name: /leaf/i });
	await expect.poll(() => studio.inkOn(view)).toBeGreaterThan(0.02);
	const { data, width } = await studio.pixels(view);
	const luma = (at: number) => 0.2126 * data[at] + 0.7152 * data[at + 1] + 0.0722 * data[at + 2];
	/** Paper, in the light or not, is nearly grey; leaves and stalks are green. */
	const isPaper = (at: number) => Math.abs(data[at] - data[at + 1]) < 20 && Math.abs(data[at + 1] - data[at + 2]) < 20;
	// Not beside the leaf, whose edges are smoothed.
	const offsets = [0, -3, 3, -6, 6];
	const isOpen = (at: number) => offsets.every((y) => offsets.every((x) => isPaper(at + 4 * (y * width + x))));
	const rows = data.length / 4 / width;
	let [left, right, steepest] = [255, 255, 0];
	for (let row = Math.floor(0.3 * rows); row < 0.6 * rows; row += 3) {
		for (let column = 6; column < 0.84 * width; column++) {
			const at = 4 * (row * width + column);
			if (!isOpen(at)) continue;
			steepest = Math.max(steepest, Math.abs(luma(at) - luma(at - 4)));
			if (column < 0.3 * width) left = Math.min(left, luma(at));
			else if (column > 0.5 * width) right = Math.min(right, luma(at));
		}
	}
	expect(right).toBeLessThan(0.95 * left);
	expect(steepest).toBeLessThan(4);
});
