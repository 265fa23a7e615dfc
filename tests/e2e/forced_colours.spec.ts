/** The choice is visible with forced colours. */
import type { Locator } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const look = (one: Locator) =>
	one.evaluate((element) => {
		const { backgroundColor, outlineStyle } = getComputedStyle(element);
		return `${backgroundColor} ${outlineStyle}`;
	});

test("choices, pressed buttons and the preset that is shown stand out in forced colours", async ({ page }) => {
	await page.emulateMedia({ forcedColors: "active" });
	const studio = await new StudioPage(page).open("?v=2&model=root&preset=tap");
	const run = page.locator("[data-key=life] label", { hasText: "Run" });
	const grow = page.locator("[data-key=life] label", { hasText: "Grow" });
	expect(await look(run)).not.toBe(await look(grow));
	const others = page.locator("button.preset:not([aria-current=true])");
	const shown = page.locator("button.preset[aria-current=true]");
	expect(await look(shown)).not.toBe(await look(others.first()));
	await page.setViewportSize({ width: 390, height: 844 });
	const views = page.locator(".switch label");
	expect(await look(views.filter({ has: page.locator(":checked") }))).not.toBe(await look(views.first()));
	await expect(studio.button("Play")).toBeVisible();
});
