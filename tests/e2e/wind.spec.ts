import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** Whether two pictures are the same but for the last digit. */
const same = (one: Uint8Array, other: Uint8Array) =>
	one.length === other.length && one.every((level, at) => Math.abs(level - other[at]) <= 2);

/** A bunch has shaders of its own, a tree three's with a shadow map. */
for (const query of ["?v=2&preset=redcurrant&count=20", "?v=2&model=tree&preset=sphere&n=60"]) {
	test.describe(query, () => {
		test.use({ drawn: true, viewport: { width: 480, height: 320 } });

		test("a wind sways the plant while it is on; before and after it is at rest", async ({ page }) => {
			const studio = await new StudioPage(page).open(query);
			await studio.stands();
			await page.waitForLoadState("networkidle");
			const wind = studio.button("Wind");
			// Its ring is over the view.
			await wind.focus();
			const view = page.locator("canvas.stage-surface");
			const picture = async () => (await studio.pixels(view)).data;
			let rest = await picture();
			const still = async () => {
				const before = rest;
				rest = await picture();
				return same(rest, before);
			};
			await expect.poll(still, { intervals: [700] }).toBe(true);
			await expect(wind).toHaveAttribute("aria-pressed", "false");
			await wind.press("Enter");
			await expect(wind).toHaveAttribute("aria-pressed", "true");
			await expect.poll(async () => same(await picture(), rest)).toBe(false);
			const one = await picture();
			await expect.poll(async () => same(await picture(), one)).toBe(false);
			await wind.press("Enter");
			await expect.poll(async () => same(await picture(), rest)).toBe(true);
		});
	});
}

test("there is no wind where less motion is wished for, nor for a root", async ({ page }) => {
	await page.emulateMedia({ reducedMotion: "reduce" });
	const studio = await new StudioPage(page).open();
	await expect(studio.button("Reset view")).toBeVisible();
	await expect(studio.button("Wind")).toHaveCount(0);
	await page.emulateMedia({ reducedMotion: "no-preference" });
	await expect(studio.button("Wind")).toHaveCount(1);
	await page.locator("[data-preset=carrot]").click();
	await expect(page.getByRole("application", { name: /^Root/ })).toBeVisible();
	await expect(studio.button("Wind")).toHaveCount(0);
});
