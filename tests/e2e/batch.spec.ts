import type { Locator, Page } from "@playwright/test";
import { strFromU8, unzipSync } from "fflate";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const PLANT = "?v=2&preset=lychee&count=12";

/** Opens the dialog of the batch export, for JSON files. */
async function openBatch(page: Page, address = PLANT) {
	const studio = await new StudioPage(page).open(address);
	await studio.chooseFormat("batch");
	const dialog = page.getByRole("dialog", { name: "Export batch (ZIP)" });
	await dialog.getByLabel("Files").selectOption("JSON");
	return { studio, dialog, grow: dialog.getByRole("button", { name: "Grow and download" }) };
}

/** Adds a row and chooses its setting by the label in the list. */
async function addRow(dialog: Locator, setting: string): Promise<Locator> {
	await dialog.getByRole("button", { name: "Add a setting" }).click();
	const chooser = dialog.getByRole("combobox", { name: "Setting", exact: true }).last();
	await expect(chooser).toBeFocused();
	await chooser.selectOption(setting);
	return dialog.getByRole("group", { name: setting, exact: true });
}

test("a batch varies settings that are chosen from lists, in the units of the panel", async ({ page }) => {
	const { studio, dialog, grow } = await openBatch(page);
	await dialog.getByLabel("Number of plants").fill("3");
	await dialog.getByLabel("Number of the first plant").fill("5");

	// Degrees, in a range.
	const sun = await addRow(dialog, "Sun height");
	await expect(sun).toContainText("0 … 90 °");
	await sun.getByLabel("From: Sun height in degrees").fill("20");
	await sun.getByLabel("To: Sun height in degrees").fill("40");
	// Millimetres in the panel, pixels of the paper in links.
	const length = await addRow(dialog, "Length");
	await length.getByLabel("Kind of variation").selectOption("Same for all plants");
	await length.getByLabel("Length in millimetres").fill("100");
	await length.getByLabel("Length in millimetres").press("Tab");
	// A choice.
	const fruit = await addRow(dialog, "Type of fruit");
	for (const option of await fruit.getByRole("checkbox").all()) await option.uncheck();
	await fruit.getByRole("checkbox", { name: "Duku" }).check();
	// A row that is removed does not vary.
	await addRow(dialog, "Age");
	await dialog.getByRole("button", { name: "Remove “Age”" }).click();
	await expect(dialog.getByRole("button", { name: "Add a setting" })).toBeFocused();

	await expect(dialog.locator(".summary")).toHaveText(
		/^3 plants in a ZIP file with 5 files, up to about [\d.,]+ (kB|MB)$/,
	);
	const { name, bytes } = await studio.downloaded(() => grow.click());
	expect(name).toBe("lychee-5-7.zip");
	const files = unzipSync(new Uint8Array(bytes));
	expect(Object.keys(files)).toEqual(["lychee-5.json", "lychee-6.json", "lychee-7.json", "plants.csv", "series.json"]);

	const { plants, vary } = JSON.parse(strFromU8(files["series.json"]));
	expect(plants).toBe("5-7");
	expect(Object.keys(vary)).toEqual(["sun_height", "l", "fruit"]);
	expect(vary).toMatchObject({ sun_height: "20..40", fruit: "duku" });

	const [header, ...rows] = strFromU8(files["plants.csv"]).trimEnd().split("\r\n");
	const column = (key: string) => rows.map((row) => row.split(",")[header.split(",").indexOf(key)]);
	for (const degrees of column("set_sun_height").map(Number)) {
		expect(degrees).toBeGreaterThanOrEqual(20);
		expect(degrees).toBeLessThanOrEqual(40);
	}
	expect(new Set(column("set_sun_height")).size).toBe(3);
	expect(column("set_fruit")).toEqual(["duku", "duku", "duku"]);
	await expect(dialog).toBeHidden();

	// The panel shows the same millimetres for the link of a plant.
	const link = column("link")[0];
	await studio.open(link.slice(link.indexOf("?")));
	await expect(page.getByLabel("Length in millimetres", { exact: true })).toHaveValue(/^100(\.[01])?$|^99\.9$/);
});

test("a batch reports errors at the row, and can be cancelled", { tag: "@long" }, async ({ page }) => {
	const { dialog, grow } = await openBatch(page);
	const age = await addRow(dialog, "Age");
	const to = age.getByLabel("To: Age in percent");
	await to.fill("900");
	await grow.click();
	await expect(age.getByRole("alert")).toHaveText("Enter a number from 0 to 125 %.");
	await expect(to).toBeFocused();
	await expect(to).toHaveAccessibleDescription(/^Enter a number from 0 to 125 %\./);
	await expect(dialog.getByRole("progressbar")).toHaveCount(0);
	await to.fill("110");
	await to.press("Tab");
	await expect(age.getByRole("alert")).toBeHidden();

	await dialog.getByLabel("Number of plants").fill("1000");
	await grow.click();
	await expect(dialog.getByRole("progressbar", { name: "Growing the batch" })).toBeVisible();
	await expect(dialog.getByRole("status")).toContainText(/[1-9]\d* of 1,000/);
	await dialog.getByRole("button", { name: /^Cancel/ }).click();
	await expect(dialog.getByRole("progressbar")).toHaveCount(0);
	await expect(dialog.locator("p[role=alert]")).toBeHidden();
	await expect(grow).toBeVisible();
});

test("a batch varies the constants of a grammar", { tag: "@long" }, async ({ page }) => {
	const { studio, dialog, grow } = await openBatch(page, "?v=2&model=grammar&preset=shrub");
	await dialog.getByLabel("Number of plants").fill("1");
	await dialog.getByRole("button", { name: "Add a setting" }).click();
	const chooser = dialog.getByRole("combobox", { name: "Setting", exact: true });
	const constant = await chooser.locator("optgroup[label='Constants of the grammar'] option").first().innerText();
	await chooser.selectOption(constant);
	await grow.click();
	await expect(dialog.getByRole("alert").filter({ visible: true })).toHaveText("Enter a number, for example 0.5.");
	await dialog.getByLabel("Kind of variation").selectOption("Same for all plants");
	await dialog.getByRole("textbox", { name: `${constant}, typed value`, exact: true }).fill("20,5");
	const { bytes } = await studio.downloaded(() => grow.click());
	const files = unzipSync(new Uint8Array(bytes));
	expect(JSON.parse(strFromU8(files["series.json"])).vary).toEqual({ [constant]: "20.5" });
});

for (const width of [320, 390])
	test(`the batch dialog fits a window ${width} pixels wide`, async ({ page }) => {
		await page.setViewportSize({ width, height: 640 });
		const { dialog } = await openBatch(page);
		await addRow(dialog, "Sun height");
		await addRow(dialog, "Type of fruit");
		await addRow(dialog, "Skin colour");
		const cut = await dialog.evaluate((box) =>
			[box, ...box.querySelectorAll(".vary-row, .vary-row *, label")]
				.filter((each) => each.getBoundingClientRect().right > box.getBoundingClientRect().right + 0.5)
				.map((each) => each.outerHTML.slice(0, 80)),
		);
		expect(cut).toEqual([]);
		expect(await dialog.evaluate((box) => box.scrollWidth - box.clientWidth)).toBe(0);
	});
