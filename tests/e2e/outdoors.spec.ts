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
		/** Returns red, green and blue in the middle of the view, at a share of its height. */
		const colourAt = async (share: number) => {
			const { width, data } = await studio.pixels(page.locator("canvas.stage-surface"));
			const row = Math.round(share * (data.length / 4 / width - 1));
			return [...data.slice(4 * (row * width + (width >> 1)), 4 * (row * width + (width >> 1)) + 3)];
		};
		const blueness = async () => {
			const [red, , blue] = await colourAt(0.02);
			return blue - red;
		};
		await expect.poll(blueness).toBeGreaterThan(15);
		const [, green, blue] = await colourAt(0.98);
		expect(green).toBeGreaterThan(blue + 15);
		await studio.button("Outdoors").press("Enter");
		await expect.poll(blueness).toBeLessThan(0);
	});
});
