import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("measures are told in words, with unit, descriptor and class, each explained in a sentence", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=pinot-noir");
	await expect(studio.measure("bunch_length")).toContainText(/Bunch length\s*OIV 202: class \d, \w+/);
	await expect(studio.measure("bunch_length").locator(".value")).toHaveText(/^\d+ mm$/);
	await expect(studio.measure("coverage").locator(".value")).toHaveText(/^\d+\.\d %$/);
	await expect(studio.measure("berry_count").locator(".value")).toHaveText(await studio.readout("Berries").innerText());
	await studio.measure("bunch_length").locator("summary").click();
	const sentence = page.getByText("the peduncle does not count");
	await expect(sentence.first()).toBeVisible();
	await expect(sentence.first()).toContainText("Not compared with its source: limits.");
	await expect(page.getByText("NaN")).toHaveCount(0);
});

test("while a hand moves, what was last measured stays; it is measured anew on release", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=pinot-noir");
	const length = studio.measure("bunch_length").locator(".value");
	const before = await length.innerText();
	const { x, y } = await studio.grip("Front", "p2");
	await page.mouse.move(x, y);
	await page.mouse.down();
	await studio.regrown(() => page.mouse.move(x, y + 12, { steps: 3 }));
	await expect(length).toHaveText(before);
	await expect(page.locator(".stale")).toHaveAttribute("aria-busy", "true");
	await page.mouse.up();
	await expect(page.locator(".stale")).toHaveCount(0);
	await expect(length).not.toHaveText(before);
});

test("what is not there is told by reason", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=long-conical&count=60");
	await expect(studio.missing("not set")).toHaveText(/^\d+ flowers that set no berry$/);
});
