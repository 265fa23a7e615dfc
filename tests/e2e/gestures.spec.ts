import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const FLOWER = "?v=2&model=flower&preset=tulip";
const circle = (page: Page) => page.getByRole("button", { name: /^bend/ });

test("the pointer bends and lengthens the stem, as one step; the arrows of the circle go on; the next two come", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open(FLOWER);
	await studio.button("Gestures").click();
	await expect(circle(page)).toBeVisible();
	const before = await circle(page).getAttribute("aria-label");
	const grown = await studio.fingerprint.textContent();
	const box = await page.getByRole("application", { name: /^Flower/ }).boundingBox();
	if (!box) throw new Error("no canvas");
	await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
	await page.mouse.down();
	await page.mouse.move(box.x + box.width * 0.75, box.y + box.height * 0.25, { steps: 4 });
	await page.mouse.up();
	await expect(circle(page)).not.toHaveAccessibleName(before ?? "");
	await expect(studio.fingerprint).not.toHaveText(grown ?? "");
	// Two values beside the preset's text, not the whole of it: to the right bends to the right, in the first view.
	await expect(page).toHaveURL(/[?&]define=bend:[\d.]+,length:[\d.]+$/);
	// The circle is where the pointer was.
	const there = await circle(page).boundingBox();
	expect(Math.abs((there?.x ?? 0) + (there?.width ?? 0) / 2 - (box.x + box.width * 0.75))).toBeLessThan(20);
	expect(Math.abs((there?.y ?? 0) + (there?.height ?? 0) / 2 - (box.y + box.height * 0.25))).toBeLessThan(20);
	await page.keyboard.press("ControlOrMeta+z");
	await expect(circle(page)).toHaveAccessibleName(before ?? "");
	await expect(studio.fingerprint).toHaveText(grown ?? "");
	await circle(page).focus();
	for (let i = 0; i < 3; i++) await page.keyboard.press("ArrowUp");
	await expect(circle(page)).not.toHaveAccessibleName(before ?? "");
	// A run of presses is one step.
	await page.keyboard.press("ControlOrMeta+z");
	await expect(circle(page)).toHaveAccessibleName(before ?? "");
	await circle(page).focus();
	await page.keyboard.press("PageDown");
	await expect(circle(page)).toHaveCount(0);
	await studio.button("Gestures").click();
	await expect(page.getByRole("group", { name: "Gestures" }).getByRole("combobox")).toHaveCount(0);
});
