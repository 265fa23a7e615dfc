import { expect, test } from "./fixtures";
import { framesRequested } from "./frames";
import { StudioPage } from "./studio_page";

/** The share of the window that the 3-D view covers. */
const share = (studio: StudioPage) =>
	studio.canvas.evaluate((canvas) => {
		const { width, height } = canvas.getBoundingClientRect();
		return (width * height) / (innerWidth * innerHeight);
	});

test("F shows only the plant, which turns, in the whole window; F and Escape lead back to the button", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
	await studio.stands();
	const present = studio.button("Present the plant");
	await present.focus();
	await page.keyboard.press("f");
	await expect(present).toBeHidden();
	await expect(page.getByRole("slider")).toHaveCount(0);
	await expect(page.locator(".caption")).toBeHidden();
	await expect(page.locator(".scale-bar")).toHaveCount(0);
	await expect(studio.canvas).toBeFocused();
	await expect.poll(() => share(studio)).toBe(1);
	expect(await framesRequested(page)).toBeGreaterThan(10);
	await page.keyboard.press("f");
	await expect(present).toBeFocused();
	await expect.poll(() => share(studio)).toBeLessThan(0.6);
	await expect.poll(() => framesRequested(page)).toBe(0);

	await page.keyboard.press("Enter");
	await expect.poll(() => share(studio)).toBe(1);
	await page.keyboard.press("Escape");
	await expect(present).toBeFocused();
	expect(await page.evaluate(() => document.fullscreenElement)).toBe(null);
});

test("the buttons of a presentation appear when the pointer moves, and by Tab", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
	await studio.stands();
	await page.keyboard.press("f");
	const buttons = page.locator(".presentation-buttons");
	await expect(buttons).toHaveCSS("opacity", "0");
	await page.mouse.move(200, 200);
	await page.mouse.move(210, 200);
	await expect(buttons).toHaveCSS("opacity", "1");
	await expect(buttons).toHaveCSS("opacity", "0");
	await page.keyboard.press("Tab");
	await expect(buttons).toHaveCSS("opacity", "1");
	await expect(studio.button("Scale bar")).toBeFocused();
	await page.keyboard.press("Enter");
	await expect(page.locator(".scale-bar")).toBeVisible();
	await studio.button("Leave").click();
	await expect(buttons).toHaveCount(0);
	await expect(studio.slider("Length")).toBeVisible();
});

test("leaving the full screen by the browser leaves the presentation", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
	await studio.button("Present the plant").click();
	await expect.poll(() => page.evaluate(() => document.fullscreenElement !== null)).toBe(true);
	await page.evaluate(() => document.exitFullscreen());
	await expect(studio.slider("Length")).toBeVisible();
	await expect(studio.button("Present the plant")).toBeFocused();
});

test.describe("with reduced motion", () => {
	test.use({ contextOptions: { reducedMotion: "reduce" } });

	test("the plant of a presentation rests, and F is no key without single-letter shortcuts", async ({ page }) => {
		await page.addInitScript(() => {
			if (!localStorage.getItem("panicle.ui")) localStorage.setItem("panicle.ui", JSON.stringify({ letters: false }));
		});
		const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
		await studio.stands();
		await page.keyboard.press("f");
		await expect(studio.slider("Length")).toBeVisible();
		await studio.button("Present the plant").click();
		await expect.poll(() => share(studio)).toBe(1);
		await expect.poll(() => framesRequested(page)).toBe(0);
		await page.keyboard.press("f");
		expect(await share(studio)).toBe(1);
		await page.keyboard.press("Escape");
		await expect(studio.slider("Length")).toBeVisible();
	});
});
