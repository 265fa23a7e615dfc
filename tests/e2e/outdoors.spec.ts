import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("a button shows a tree on paper or outdoors, and the page remembers it", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=growth&preset=figure-4");
	await studio.stands();
	const outdoors = studio.button("Outdoors");
	await expect(outdoors).toHaveAttribute("aria-pressed", "true");
	await outdoors.press("Enter");
	await expect(outdoors).toHaveAttribute("aria-pressed", "false");
	await page.reload();
	await expect(outdoors).toHaveAttribute("aria-pressed", "false");
	await test.step("bunches stay on paper, without such a button", async () => {
		await studio.choosePreset("bunch", "merlot");
		await expect(page).toHaveTitle(/Merlot/);
		await expect(outdoors).toHaveCount(0);
	});
});

test.describe("to the eye", () => {
	test.use({ drawn: true });

	test("outdoors the sky is blue over green ground; on paper the corners have the paper's colour", {
		tag: "@long",
	}, async ({ page }) => {
		const studio = await new StudioPage(page).open("?v=2&model=growth&preset=figure-4");
		await studio.stands();
		/** Returns red, green and blue of a pixel at shares of the canvas's width and height. */
		const pixelAt = (x: number, y: number) =>
			page.locator("canvas.stage-surface").evaluate(
				async (canvas: HTMLCanvasElement, [x, y]) => {
					const picture = await createImageBitmap(canvas);
					const copy = new OffscreenCanvas(1, 1).getContext("2d") as OffscreenCanvasRenderingContext2D;
					copy.drawImage(picture, -Math.round(x * picture.width), -Math.round(y * picture.height));
					return [...copy.getImageData(0, 0, 1, 1).data.slice(0, 3)];
				},
				[x, y] as const,
			);
		const [red, , blue] = await pixelAt(0.03, 0.04);
		expect(blue).toBeGreaterThan(red + 15);
		const [, green, below] = await pixelAt(0.03, 0.97);
		expect(green).toBeGreaterThan(below + 15);
		await studio.button("Outdoors").press("Enter");
		await expect
			.poll(async () => Math.max(...(await pixelAt(0.03, 0.04))) - Math.min(...(await pixelAt(0.03, 0.04))))
			.toBeLessThan(20);
	});
});
