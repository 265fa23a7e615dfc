/** Preferences of visitors: more contrast, and less motion. */
import type { Page } from "@playwright/test";
import { violations } from "./axe";
import { expect, test } from "./fixtures";
import { framesRequested, passFrames } from "./frames";
import { defineMeasures, movingParts, weakBorders } from "./measures";
import { agesUntilGrown } from "./played_ages";
import { StudioPage } from "./studio_page";

const BUNCH = "?v=2&preset=redcurrant&count=12";

test.use({ viewport: { width: 1280, height: 800 } });
test.beforeEach(async ({ page }) => {
	await page.addInitScript(defineMeasures);
});

/** Presses on the middle of the view, moves fast and lets go. */
async function fling(page: Page): Promise<void> {
	const box = await page.locator("panicle-stage canvas").boundingBox();
	if (!box) throw new Error("The view is not on the page.");
	const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
	await page.mouse.move(x, y);
	await page.mouse.down();
	await page.mouse.move(x + 90, y, { steps: 3 });
	await page.mouse.up();
}

test("more contrast gives texts 7 to 1 and borders of controls 4.5 to 1, in both themes", async ({ page }) => {
	const expectContrast = async (place: string) => {
		for (const colorScheme of ["light", "dark"] as const) {
			await page.emulateMedia({ contrast: "more", colorScheme });
			await passFrames(page, 2);
			expect.soft(await violations(page, ["color-contrast-enhanced"]), `${place}, ${colorScheme}: texts`).toEqual([]);
			expect.soft(await weakBorders(page), `${place}, ${colorScheme}: borders`).toEqual([]);
		}
	};
	await page.goto("./");
	await expect(page.locator(".family")).toHaveCount(8);
	await expectContrast("home");
	const studio = await new StudioPage(page).open(BUNCH);
	await studio.presetsListed();
	await expectContrast("studio");
	await studio.openDownloads();
	await expectContrast("download");
	await page.emulateMedia({ contrast: "no-preference" });
	expect(await weakBorders(page), "borders without the preference").not.toEqual([]);
});

test("less motion: nothing moves that the visitor does not move, and nothing goes on by itself", async ({ page }) => {
	await page.emulateMedia({ reducedMotion: "reduce" });
	const studio = await new StudioPage(page).open(BUNCH);
	await studio.stands();
	await expect.poll(() => framesRequested(page)).toBe(0);
	const age = studio.slider("Age");
	const before = await age.inputValue();
	expect(await movingParts(page)).toEqual([]);

	await test.step("after the picture is turned by the pointer", async () => {
		await fling(page);
		await passFrames(page, 4);
		expect(await framesRequested(page)).toBeLessThanOrEqual(1);
	});
	await test.step("after another plant has grown", async () => {
		await studio.regrown(() => studio.button("New variation").click());
		await passFrames(page, 4);
		expect(await framesRequested(page)).toBeLessThanOrEqual(1);
	});
	await test.step("and its age only changes on request, from stage to stage", async () => {
		expect(await age.inputValue()).toBe(before);
		await age.fill("30");
		const seen = agesUntilGrown(page);
		await studio.button("Play").click();
		expect(await seen).toEqual(["30", "60", "100"]);
	});
	await test.step("unlike with motion, where the picture goes on turning", async () => {
		await page.emulateMedia({ reducedMotion: "no-preference" });
		await fling(page);
		expect(await framesRequested(page)).toBeGreaterThan(3);
	});
});

test("less motion: the home page, the dialogs and the grammar have no transitions", { tag: "@long" }, async ({
	page,
}) => {
	await page.emulateMedia({ reducedMotion: "reduce" });
	await page.goto("./");
	await expect(page.locator(".family")).toHaveCount(8);
	expect(await movingParts(page)).toEqual([]);
	const studio = await new StudioPage(page).open("?v=2&model=grammar&preset=plant-c");
	await studio.button("Grammar").click();
	await expect(page.locator(".pane")).toBeVisible();
	expect(await movingParts(page)).toEqual([]);
	await studio.browse();
	expect(await movingParts(page)).toEqual([]);
});

for (const [width, height] of [
	[820, 1180],
	[1180, 820],
]) {
	test.describe(`on a tablet of ${width} × ${height}`, () => {
		test.use({ viewport: { width, height }, hasTouch: true });

		test("each point of an enlarged outline is taken by a press at its place, and by keys", async ({ page }) => {
			await new StudioPage(page).open("?v=2&model=leaf&preset=maple");
			await page.getByRole("button", { name: "Enlarge: Outline" }).click();
			const points = page.locator("panicle-outline [data-handle]");
			await expect(page.getByRole("button", { name: "Reduce: Outline" })).toBeVisible();
			await passFrames(page, 4);
			const count = await points.count();
			expect(count).toBe(59);

			const places = await points.evaluateAll((all) =>
				all.map((point) => {
					const { x, y, width, height } = point.getBoundingClientRect();
					return { x: x + width / 2, y: y + height / 2 };
				}),
			);
			const inWindow = places.filter(({ x, y }) => x > 0 && y > 0 && x < width && y < height);
			expect(inWindow).toHaveLength(count);
			const focused = () =>
				page.evaluate(() => {
					const { activeElement } = document.querySelector("panicle-outline")?.shadowRoot ?? {};
					return (activeElement as HTMLElement | null | undefined)?.dataset.handle;
				});
			const names = await points.evaluateAll((all) => all.map((point) => (point as HTMLElement).dataset.handle));
			const pressed: (string | undefined)[] = [];
			for (const { x, y } of places) {
				await page.mouse.click(x, y);
				pressed.push(await focused());
			}
			expect(pressed).toEqual(names);

			await points.first().focus();
			const stepped = [await focused()];
			for (let step = 1; step < count; step++) {
				await page.keyboard.press("PageDown");
				stepped.push(await focused());
			}
			expect(stepped).toEqual(names);
		});
	});
}
