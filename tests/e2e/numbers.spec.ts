import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("measures are shown in words, with unit, descriptor and class, each explained in a sentence", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=pinot-noir");
	await expect(studio.measure("bunch_length")).toContainText(/Bunch length\s*OIV 202: class \d, \w+/);
	await expect(studio.measure("bunch_length").locator(".value")).toHaveText(/^\d+ mm$/);
	await expect(studio.measure("coverage").locator(".value")).toHaveText(/^\d+\.\d %$/);
	await expect(studio.measure("berry_count").locator(".value")).toHaveText(await studio.readout("Berries").innerText());
	await studio.measure("bunch_length").locator("summary").click();
	const sentence = page.getByText("the peduncle does not count");
	await expect(sentence.first()).toBeVisible();
	await expect(sentence.first()).toContainText("Not yet checked against the OIV’s list: limits.");
	await expect(page.getByText("NaN")).toHaveCount(0);
});

test("a number is asked for where it stands, and the plant follows, as one step", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=riesling");
	const row = studio.measure("bunch_length");
	await row.locator(".value").click();
	const field = row.getByRole("textbox", { name: "Set target" });
	await expect(field).toBeFocused();
	await studio.regrown(async () => {
		await page.keyboard.type("160");
		await page.keyboard.press("Enter");
	});
	await expect(studio.notices).toContainText(/Bunch length: 160 mm (reached|asked, 1\d\d(\.\d)? mm reached)/);
	await expect(studio.notices).toContainText(/Length 115\.1 → 1\d\d(\.\d)? mm/);
	await expect(row.locator(".value")).toHaveText(/^1(59|60|61) mm$/);
	await expect(row).toContainText("Target: 160 mm");
	await studio.button("Undo").click();
	await expect(studio.button("Undo")).toBeDisabled();
	await field.fill("high");
	await field.press("Enter");
	await expect(row.getByRole("alert")).toHaveText("Enter a positive number.");
});

test("while a hand moves, what was last measured stays; it is measured anew on release", { tag: "@long" }, async ({
	page,
}) => {
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

test("missing measures are shown with their reason", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=long-conical&count=60");
	await expect(studio.missing("not set")).toHaveText(/^\d+ flowers did not set fruit$/);
});
