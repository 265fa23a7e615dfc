/** A plant of known size, one upright line, to check lengths in the 3-D view. */
import { expect, type Page } from "@playwright/test";
import { compressText } from "../../web/src/specimen/compressed_text";
import { StudioPage } from "./studio_page";

/** Height of the line, metres: 100 units of 5 mm. */
export const HEIGHT = 0.5;

interface Point {
	readonly x: number;
	readonly y: number;
}

/** The two ends of the line, in pixels of the page. */
export interface Ends {
	readonly top: Point;
	readonly foot: Point;
}

/** Opens the line and looks at it from the height of its middle; needs `drawn: true`. */
export async function openStick(page: Page): Promise<StudioPage> {
	await page.setViewportSize({ width: 1100, height: 900 });
	const text = await compressText("axiom: F(100)\n");
	const studio = await new StudioPage(page).open(`?v=2&model=grammar&unit=5&thickness=2#g=${text}`);
	await studio.stands();
	await expect(studio.measure("height")).toContainText("50.0 cm");
	await viewOf(page).focus();
	for (const key of ["ArrowUp", "-"]) await page.keyboard.press(key);
	return studio;
}

/** The 3-D view's canvas. */
export const viewOf = (page: Page) => page.locator(".stage-surface");

/** Finds the ends of the line: its highest and its lowest dark pixels, once two pictures agree. */
export async function endsOf(studio: StudioPage): Promise<Ends> {
	let found = await darkColumn(studio);
	await expect(async () => {
		const before = found;
		found = await darkColumn(studio);
		expect(found).toEqual(before);
		expect(found.foot.y - found.top.y).toBeGreaterThan(50);
	}).toPass();
	return found;
}

/** Looks at the middle tenth of the view only, above the caption, where nothing else is written. */
async function darkColumn(studio: StudioPage): Promise<Ends> {
	const view = viewOf(studio.page);
	// The focus ring is dark, too.
	await view.blur();
	const { data, width } = await studio.pixels(view);
	const box = await view.boundingBox();
	if (!box) throw new Error("no 3-D view");
	const dark: Point[] = [];
	for (let pixel = 0; pixel < data.length / 4 - 30 * width; pixel++) {
		const [x, y] = [pixel % width, Math.floor(pixel / width)];
		if (Math.abs(x - width / 2) > width / 20) continue;
		if (data[4 * pixel] + data[4 * pixel + 1] + data[4 * pixel + 2] < 400)
			dark.push({ x: box.x + x + 0.5, y: box.y + y });
	}
	const [top, foot] = [dark[0], dark.at(-1)];
	if (!top || !foot) throw new Error("no line to be seen");
	const middle = dark.reduce((sum, { x }) => sum + x / dark.length, 0);
	return { top: { x: middle, y: top.y }, foot: { x: middle, y: foot.y + 1 } };
}
