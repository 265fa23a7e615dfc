import type { Locator, Page } from "@playwright/test";
import { DIALOGS, openDialog } from "./dialogs";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/**
 * Those of some controls whose middle is not on the screen, or has something over it, by their names; of two handles the
 * nearest is taken, not the upper.
 */
const outOfHand = (controls: Locator) =>
	controls.evaluateAll((elements) =>
		elements.flatMap((element) => {
			element.scrollIntoView({ block: "center", inline: "center" });
			const { left, top, width, height } = element.getBoundingClientRect();
			const [x, y] = [left + width / 2, top + height / 2];
			const hit = (element.getRootNode() as Document | ShadowRoot).elementFromPoint(x, y);
			const inside = x > 0 && y > 0 && x < innerWidth && y < innerHeight;
			const same = hit?.closest(".handle")
				? element.matches(".handle")
				: hit?.contains(element) || element.contains(hit);
			return inside && hit !== null && same === true ? [] : [element.ariaLabel ?? element.id ?? element.textContent];
		}),
	);

async function expectAllAtHand(page: Page, controls: string): Promise<void> {
	const all = page.locator(controls);
	expect(await all.count()).toBeGreaterThan(0);
	// A view that has just become visible gets its layout in the next frame.
	await expect.poll(() => outOfHand(all), controls).toEqual([]);
}

for (const [width, height] of [
	[720, 450],
	[667, 375],
	[320, 256],
	[844, 390],
	[800, 330],
]) {
	test.describe(`at ${width} × ${height}`, () => {
		test.use({ viewport: { width, height } });

		test("every control is within reach, nothing scrolls sideways, and a slider works", {
			tag: width === 320 ? [] : "@long",
		}, async ({ page }) => {
			const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
			await expect(studio.button("Reset view")).toBeVisible();
			const sideways = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
			expect(await sideways()).toBeLessThanOrEqual(0);
			for (const group of ["Branching", "Look"]) await studio.openGroup(group);
			await expectAllAtHand(
				page,
				"button:visible:not(.handle, .preset, .stage-name), input:visible:not([type=radio], [type=file]), select:visible, summary:visible",
			);
			for (const view of await page.getByRole("radio", { name: /Front|Side/ }).all()) {
				if (!(await view.isVisible())) continue;
				await view.check();
				await expectAllAtHand(page, "panicle-profile:visible .handle");
			}
			expect(await sideways()).toBeLessThanOrEqual(0);
			await test.step("by pointer and by key, and what it does is seen", async () => {
				const slider = studio.slider("Length");
				await slider.scrollIntoViewIfNeeded();
				const box = await slider.boundingBox();
				if (!box) throw new Error("no slider");
				await studio.regrown(() => page.mouse.click(box.x + box.width / 3, box.y + box.height / 2));
				await studio.regrown(() => slider.press("PageUp"));
				await expect(slider).toBeInViewport();
				await studio.canvas.scrollIntoViewIfNeeded();
				expect((await studio.canvas.boundingBox())?.height).toBeGreaterThanOrEqual(90);
			});
		});
	});
}

test("focus on a button that opens a file keeps the page in its place", async ({ page }) => {
	await page.setViewportSize({ width: 390, height: 844 });
	await (await new StudioPage(page).open("?v=2&model=tree&preset=sphere")).openAdvanced();
	const file = page.getByLabel(/^Choose inner mesh/);
	await file.focus();
	await expect(file).toBeFocused();
	await expect(page.getByText(/^Choose inner mesh/)).toBeInViewport();
	expect(await page.locator(".studio").evaluate((studio) => studio.scrollTop)).toBe(0);
});

test("the strip is as high in every family, with a scroll bar or without", { tag: "@long" }, async ({ page }) => {
	await page.setViewportSize({ width: 1440, height: 900 });
	const heights: number[] = [];
	for (const model of ["bunch", "root", "flower"]) {
		await new StudioPage(page).open(`?v=2&model=${model}`);
		await expect(page.locator(".strip .preset").nth(3)).toBeVisible();
		heights.push(await page.locator(".strip").evaluate((strip: HTMLElement) => strip.offsetHeight));
	}
	expect(new Set(heights).size, heights.join()).toBe(1);
});

for (const [query, editors] of [
	["?model=leaf&preset=lime&n=200", { Outline: "panicle-outline" }],
	["?model=tree&preset=sphere&n=60", { Boundary: "panicle-boundary", Plan: "panicle-plan", Sun: "panicle-sun" }],
] as const) {
	test(`every control of the editors is within reach at 320 × 256: ${query}`, { tag: "@long" }, async ({ page }) => {
		await page.setViewportSize({ width: 320, height: 256 });
		await new StudioPage(page).open(query);
		for (const [view, editor] of Object.entries(editors)) {
			await page.getByRole("radio", { name: view }).check();
			await expectAllAtHand(page, `${editor}:visible button`);
		}
		await expectAllAtHand(page, ".life-bar button:visible, .life-bar select, .actions .button:visible");
		expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
	});
}

test("every control of the home page is within reach at 320 × 256", { tag: "@long" }, async ({ page }) => {
	await page.setViewportSize({ width: 320, height: 256 });
	await page.goto("./");
	await expect(page.locator(".family")).toHaveCount(8);
	await expectAllAtHand(page, "button:visible, a[href]:visible, input:visible:not([type=file])");
});

for (const place of DIALOGS) {
	test(`every control of the dialog “${place.name}” is within reach at 320 × 256`, { tag: "@long" }, async ({
		page,
	}) => {
		await page.setViewportSize({ width: 320, height: 256 });
		const studio = await new StudioPage(page).open("?v=2&preset=redcurrant&count=12");
		await studio.presetsListed();
		await openDialog(studio, place);
		const controls = ["button", "a[href]", "input:not([type=file])", "select", "textarea", "summary"];
		await expectAllAtHand(page, controls.map((each) => `dialog[open] ${each}:visible`).join(", "));
		expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
	});
}

test("the chosen preset stands clear of the strip's edge", { tag: "@long" }, async ({ page }) => {
	await page.setViewportSize({ width: 667, height: 375 });
	await new StudioPage(page).open("?v=2&preset=merlot");
	const chosen = await page.locator("[data-preset=merlot]").boundingBox();
	const strip = await page.locator(".strip").boundingBox();
	if (!chosen || !strip) throw new Error("no strip");
	expect(chosen.x - strip.x).toBeGreaterThan(40);
	expect(strip.x + strip.width - chosen.x - chosen.width).toBeGreaterThan(40);
});

test("on a phone the stage's name stands below the thumb", { tag: "@long" }, async ({ page }) => {
	await page.setViewportSize({ width: 390, height: 844 });
	const studio = await new StudioPage(page).open();
	const name = page.locator(".stage-now");
	for (const [age, words] of [
		["0", "Flowering"],
		["100", "Ripe"],
		["125", "Shrivelled"],
	]) {
		await studio.slider("Age").fill(age);
		await expect(name).toHaveText(words);
		const [box, slider] = [await name.boundingBox(), await studio.slider("Age").boundingBox()];
		if (!box || !slider) throw new Error("no age");
		const thumb = slider.x + 12 + ((slider.width - 24) * Number(age)) / 125;
		expect(thumb).toBeGreaterThanOrEqual(box.x - 1);
		expect(thumb).toBeLessThanOrEqual(box.x + box.width + 1);
		expect(box.x).toBeGreaterThanOrEqual(slider.x);
		expect(box.x + box.width).toBeLessThanOrEqual(slider.x + slider.width);
	}
});
