import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const NATURAL = "?v=2&preset=short-conical";

/** The middle of the 3-D view, where a berry is. */
async function middle(studio: StudioPage): Promise<{ x: number; y: number }> {
	await studio.stands();
	const box = await studio.canvas.boundingBox();
	if (!box) throw new Error("no canvas");
	return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

test("a click takes the berry under it off; link, undo and reload know of it", async ({ page }) => {
	const studio = await new StudioPage(page).open(NATURAL);
	const first = await studio.fingerprint.innerText();
	const { x, y } = await middle(studio);
	await studio.button("Remove berries").click();
	await expect(studio.button("Remove berries")).toHaveAttribute("aria-pressed", "true");
	// The view may not be ready to find berries yet: a person would move the pointer again.
	await expect(async () => {
		await page.mouse.move(x + 1, y);
		await page.mouse.move(x, y);
		await expect(page.getByText(/^Berry \d+ of \d+, /)).toBeVisible({ timeout: 500 });
	}).toPass();
	const thinned = await studio.regrown(() => page.mouse.click(x, y));
	await expect(page.getByText("1 berry removed", { exact: true })).toBeVisible();
	await expect(studio.missing("by hand")).toHaveText("Removed by hand: 1");
	await expect(page).toHaveURL(/[?&]thin=[0-9a-z]+$/);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(first);
	await expect(page).not.toHaveURL(/thin=/);
	await studio.button("Redo").click();
	await expect(studio.fingerprint).toHaveText(thinned);
	await page.reload();
	await expect(studio.fingerprint).toHaveText(thinned);
	await expect(page.getByText("1 berry removed", { exact: true })).toBeVisible();
});

test("a drag turns the bunch and takes nothing off, nor does a click without the mode", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open(NATURAL);
	const { x, y } = await middle(studio);
	await page.mouse.click(x, y);
	await studio.button("Remove berries").click();
	await page.mouse.move(x, y);
	await page.mouse.down();
	await page.mouse.move(x + 60, y, { steps: 4 });
	await page.mouse.move(x, y, { steps: 4 });
	await page.mouse.up();
	await expect(page.getByText("No berries removed")).toBeVisible();
	await expect(studio.button("Undo")).toBeDisabled();
	await studio.button("Remove berries").blur();
	await page.keyboard.press("t");
	await expect(studio.button("Remove berries")).toHaveAttribute("aria-pressed", "false");
});

test("berries are gone through and taken off by keyboard, and all put back at once", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open(NATURAL);
	const first = await studio.fingerprint.innerText();
	await studio.openAdvanced();
	const berry = studio.slider("Berry");
	await berry.focus();
	await expect(berry).toHaveAttribute("aria-valuetext", /^Berry 1 of \d+, at the top, .+, [\d.]+ mm$/);
	for (const _ of [1, 2]) await page.keyboard.press("ArrowRight");
	await expect(berry).toHaveAttribute("aria-valuetext", /^Berry 3 of /);
	await studio.regrown(() => page.keyboard.press("Delete"));
	await expect(page.getByText("1 berry removed", { exact: true })).toBeVisible();
	await expect(berry).toBeFocused();
	await studio.regrown(() => studio.button("Remove").click());
	await expect(page.getByText("2 berries removed", { exact: true })).toBeVisible();
	await studio.button("Restore all").click();
	await expect(studio.fingerprint).toHaveText(first);
	await studio.button("Undo").click();
	await expect(page.getByText("2 berries removed", { exact: true })).toBeVisible();
});

test.describe("by touch", () => {
	test.use({ hasTouch: true });

	test("a tap takes a berry off", { tag: "@long" }, async ({ page }) => {
		const studio = await new StudioPage(page).open(NATURAL);
		const { x, y } = await middle(studio);
		await studio.button("Remove berries").tap();
		await studio.regrown(() => page.touchscreen.tap(x, y));
		await expect(page.getByText("1 berry removed", { exact: true })).toBeVisible();
	});
});
