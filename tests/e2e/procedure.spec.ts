import { readFileSync } from "node:fs";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** Results of links of version 1 before the second procedure. */
const PAPER = JSON.parse(readFileSync("tests/golden/bunch.json", "utf8"))["short-conical 1"].fingerprint;

const group = (studio: StudioPage, key: string) => studio.page.locator(`details[data-group=${key}]`);

test("a link of version 1 keeps the paper's bunch, to the bit, and says nothing of it", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=1&preset=short-conical");
	await expect(studio.fingerprint).toHaveText(PAPER);
	await expect(page).toHaveURL(/\?v=2&preset=short-conical&.*procedure=paper/);
	await expect(studio.notices.getByRole("listitem")).toHaveCount(0);
	await page.reload();
	await expect(studio.fingerprint).toHaveText(PAPER);
});

test("each procedure brings the controls that it uses", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
	const natural = await studio.fingerprint.innerText();
	await expect(studio.slider("Density")).toBeVisible();
	await expect(studio.slider("Age")).toBeVisible();
	await expect(studio.button("Remove berries")).toBeVisible();
	await expect(group(studio, "interaction")).toHaveCount(0);
	await studio.openGroup("Method");
	await page.getByRole("radio", { name: "Paper" }).check();
	await expect(studio.fingerprint).toHaveText(PAPER);
	await expect(page.getByRole("radio", { name: "Paper" })).toBeFocused();
	for (const name of ["Density", "Age", "Effect of sun"]) await expect(studio.slider(name)).toHaveCount(0);
	await expect(studio.button("Remove berries")).toHaveCount(0);
	await expect(group(studio, "age")).toHaveCount(0);
	await studio.openGroup("Interaction");
	await expect(studio.slider("Attempts")).toBeVisible();
	await expect(studio.slider("Sagging")).toBeVisible();
	await expect(studio.slider("Smallest radius")).toBeVisible();
	await page.getByRole("radio", { name: "Paper" }).press("ArrowRight");
	await expect(studio.fingerprint).toHaveText(natural);
	await expect(studio.button("Undo")).toBeEnabled();
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(PAPER);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(natural);
	await expect(studio.button("Undo")).toBeDisabled();
});

test("a choice drops down, is a link, and comes back by a double click or Delete", { tag: "@long" }, async ({
	page,
}) => {
	await (await new StudioPage(page).open("?v=2&preset=short-conical")).openAdvanced();
	const fruit = page.getByRole("combobox", { name: "Type of fruit" });
	await expect(fruit).toHaveAccessibleDescription(/skin and surface/);
	await fruit.selectOption("Lychee");
	await expect(page).toHaveURL(/[?&]fruit=lychee/);
	await page.getByText("Type of fruit", { exact: true }).dblclick();
	await expect(fruit).toHaveValue("0");
	await fruit.selectOption("Duku");
	await fruit.press("Delete");
	await expect(fruit).toHaveValue("0");
	await expect(page).not.toHaveURL(/fruit=/);
});

test("instances are offered of natural bunches, too, with their size before one clicks", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
	const sheet = await studio.openDownloads();
	await expect(sheet.locator("[data-format=glb-instanced] .size")).toHaveText(/^[\d.]+ (k|M)B$/, { timeout: 60_000 });
});
