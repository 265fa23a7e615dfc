import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { endsOf, HEIGHT, openStick, viewOf } from "./measured_stick";
import { StudioPage } from "./studio_page";

const tape = (page: Page) => page.getByRole("group", { name: "Measuring tape" });

/** The distance that the tape shows, metres. */
async function distance(page: Page): Promise<number> {
	const [, count, unit] =
		(await tape(page).innerText()).match(/Distance: ([\d.,]+) (mm|cm|m)$/m) ?? (await tape(page).innerText());
	return Number(count) * { mm: 0.001, cm: 0.01, m: 1 }[unit as "mm" | "cm" | "m"];
}

test("M opens the tape, which lists the size of the plant as text; Escape puts it away", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
	await studio.stands();
	await page.keyboard.press("m");
	await expect(studio.button("Measure")).toHaveAttribute("aria-pressed", "true");
	const size = /Whole plant: [\d.]+ cm high, [\d.]+ cm wide, [\d.]+ cm deep/;
	await expect(tape(page)).toContainText("Click two points of the plant.");
	await expect(tape(page)).toContainText(size);
	const before = await tape(page).innerText();
	await studio.regrown(() => studio.slider("Length").press("PageDown"));
	await expect(tape(page)).toContainText(size);
	await expect(tape(page)).not.toHaveText(before);
	await studio.slider("Length").blur();
	await page.keyboard.press("Escape");
	await expect(tape(page)).toHaveCount(0);
	await expect(studio.button("Measure")).toHaveAttribute("aria-pressed", "false");
});

test("the tape's button puts it away, and the focus goes to the view; wind puts it away, too", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
	await studio.button("Measure").click();
	await tape(page).getByRole("button", { name: "Put the measuring tape away" }).click();
	await expect(tape(page)).toHaveCount(0);
	await expect(studio.canvas).toBeFocused();
	await studio.button("Measure").click();
	await expect(tape(page)).toBeVisible();
	await studio.button("Wind on/off").click();
	await expect(tape(page)).toHaveCount(0);
	await studio.button("Measure").click();
	await expect(studio.button("Wind on/off")).toHaveAttribute("aria-pressed", "false");
});

test.describe("drawn", () => {
	test.use({ drawn: true, hasTouch: true });

	test("two clicks measure a plant of known height to 2 %, and a third click begins anew", async ({ page }) => {
		const studio = await openStick(page);
		const { top, foot } = await endsOf(studio);
		await studio.button("Measure").click();
		await expect(tape(page)).toContainText(/Whole plant: 50(\.\d)? cm high/);
		await page.mouse.click(top.x, top.y);
		await expect(tape(page)).toContainText("second point");
		await page.mouse.click(foot.x, foot.y);
		await expect(tape(page)).toContainText("Distance:");
		expect(Math.abs((await distance(page)) / HEIGHT - 1)).toBeLessThan(0.02);
		await expect(page.locator(".tape-line text")).toHaveText(/^\d+(\.\d)? cm$/);

		// From another side, and nearer, the length is the same.
		await viewOf(page).focus();
		for (const key of ["ArrowDown", "ArrowDown", "ArrowLeft", "+"]) await page.keyboard.press(key);
		const near = await endsOf(studio);
		await page.mouse.click(near.foot.x, near.foot.y);
		await expect(tape(page)).toContainText("second point");
		// A drag turns the plant and sets no point; neither does a click beside the plant.
		const box = await viewOf(page).boundingBox();
		await page.mouse.click((box?.x ?? 0) + 60, (box?.y ?? 0) + 60);
		await page.mouse.click(near.top.x, near.top.y);
		await expect(tape(page)).toContainText("Distance:");
		expect(Math.abs((await distance(page)) / HEIGHT - 1)).toBeLessThan(0.02);

		await page.keyboard.press("Escape");
		await expect(tape(page)).toContainText("two points");
		await page.touchscreen.tap(near.top.x + 8, near.top.y);
		await page.keyboard.press("Escape");
		await page.keyboard.press("Escape");
		await expect(tape(page)).toHaveCount(0);
	});

	for (const [model, query, most] of [
		["bunch", "?v=2&preset=short-conical", 0.5],
		["flower", "?model=flower&preset=tulip", 1],
		["leaf", "?model=leaf", 1],
		["stand", "?model=stand&preset=orchard", 100],
	] as const)
		test(`two clicks measure a ${model}`, { tag: "@long" }, async ({ page }) => {
			const studio = await new StudioPage(page).open(query);
			await studio.stands();
			await page.keyboard.press("m");
			const box = await viewOf(page).boundingBox();
			if (!box) throw new Error("no 3-D view");
			const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
			const words = () => tape(page).innerText();
			// Clicks around the middle, each after the result of the last: some meet the plant.
			for (let i = 0; i < 12 && !(await words()).includes("Distance:"); i++) {
				const before = await words();
				await page.mouse.click(x + 0.02 * i * box.width, y + (i % 3) * 0.1 * box.height);
				await expect
					.poll(words, { timeout: 3000 })
					.not.toBe(before)
					.catch(() => {});
			}
			const length = await distance(page);
			expect(length).toBeGreaterThan(0);
			expect(length).toBeLessThan(most);
		});
});
