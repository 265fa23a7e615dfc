import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("a photograph lies behind the front view, is shifted by hand and keys, and stays out of the link", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const address = page.url();
	await studio.openAdvanced();
	const picture = await page.evaluate(async () => {
		const canvas = new OffscreenCanvas(100, 300);
		const pen = canvas.getContext("2d") as OffscreenCanvasRenderingContext2D;
		pen.fillStyle = "#f0f";
		pen.fillRect(0, 0, 100, 300);
		return [...new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())];
	});
	await studio.drop("bunch.png", Buffer.from(picture));
	const photo = page.getByRole("application", { name: /^Photo\./ });
	await expect(photo).toBeVisible();
	/** Where the picture begins and ends on its canvas, as shares of the canvas' width. */
	const extent = () =>
		page.locator("panicle-photo canvas").evaluate((canvas) => {
			const { width, height } = canvas as HTMLCanvasElement;
			const row = (canvas as HTMLCanvasElement)
				.getContext("2d")
				?.getImageData(0, Math.round(height / 2), width, 1).data;
			const inked = Array.from({ length: width }, (_, x) => x).filter((x) => (row?.[4 * x + 3] ?? 0) > 0);
			return [inked[0] / width, (inked.at(-1) ?? 0) / width];
		});
	const [left, right] = await extent();
	expect(left + right).toBeCloseTo(1, 1);
	const box = await photo.boundingBox();
	if (!box) throw new Error("no photograph");
	const [x, y] = [box.x + 0.7 * box.width, box.y + 0.95 * box.height];
	await page.mouse.move(x, y);
	await page.mouse.down();
	await page.mouse.move(x + 0.2 * box.width, y, { steps: 4 });
	await page.mouse.up();
	await expect.poll(async () => (await extent())[0]).toBeGreaterThan(left + 0.15);
	const dragged = await extent();
	await photo.focus();
	for (let press = 0; press < 3; press++) await page.keyboard.press("Shift+ArrowLeft");
	await expect.poll(async () => (await extent())[0]).toBeLessThan(dragged[0]);
	const width = ([from, to]: number[]) => to - from;
	await page.keyboard.press("Shift++");
	await expect.poll(async () => width(await extent())).toBeGreaterThan(width(dragged));
	await studio.button("Move photo").click();
	await expect(photo).toHaveCount(0);
	await studio.regrown(() => studio.slider("Right width").press("ArrowRight"));
	await studio.button("Undo").click();
	await expect(page.locator("panicle-photo")).toHaveCount(1);
	expect(page.url()).toBe(address);
	await studio.drop("no.png", Buffer.from("no picture"));
	await expect(studio.notices).toContainText("The file is not a picture that this browser can read");
	await studio.button("Remove photo").click();
	await expect(page.locator("panicle-photo")).toHaveCount(0);
});
