import { readFileSync } from "node:fs";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** What tests/golden finds in Node, by preset and seed. */
const goldens = JSON.parse(readFileSync("tests/golden/bunch.json", "utf8")) as Record<
	string,
	{ fingerprint: string; berries: number }
>;

test("every preset grows in Chromium what it grows in Node, to the bit", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	const presets = await page.locator("[data-preset]").all();
	expect(presets).toHaveLength(15);
	for (const preset of presets) {
		const name = await preset.getAttribute("data-preset");
		const { fingerprint, berries } = goldens[`${name} 1`];
		await preset.click();
		await expect(studio.fingerprint, `${name}`).toHaveText(fingerprint);
		await expect(studio.readout("Berries"), `${name}`).toHaveText(String(berries));
	}
});

test("every preset has its picture, in both themes", async ({ page }) => {
	await new StudioPage(page).open();
	for (const theme of ["Dark theme", "Light theme"]) {
		for (const picture of await page.locator(".preset img").all()) {
			await picture.scrollIntoViewIfNeeded();
			await expect.poll(() => picture.evaluate((img: HTMLImageElement) => img.naturalWidth)).toBeGreaterThan(0);
		}
		await page.getByRole("button", { name: theme }).click();
	}
});
