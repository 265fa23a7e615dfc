import type { Locator, Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";
import { withoutHints } from "./without_hints.mjs";

const dialog = (page: Page) => page.getByRole("dialog", { name: "Search everything" });
const field = (page: Page) => page.getByRole("combobox", { name: "Search plants, settings, actions and help" });
const option = (page: Page, name: string | RegExp) => dialog(page).getByRole("option", { name });
const status = (page: Page) => dialog(page).getByRole("status");

/** The app with every model's presets, and the palette open. */
async function opened(page: Page, search?: string): Promise<StudioPage> {
	const studio = await new StudioPage(page).open(search);
	await expect(page.locator("panicle-gallery [data-preset]").first()).toBeAttached();
	await page.keyboard.press("Control+k");
	await expect(field(page)).toBeFocused();
	return studio;
}

/** The entry that the field names as the active one. */
async function active(page: Page): Promise<Locator> {
	const id = await field(page).getAttribute("aria-activedescendant");
	return page.locator(`[id="${id}"]`);
}

test("the palette chooses a plant of another model, which is one undo step, and announces it", async ({ page }) => {
	const studio = await opened(page);
	const before = await studio.fingerprint.innerText();
	await expect(async () => {
		await field(page).fill("carotte");
		await expect(option(page, /^Carrot/)).toBeVisible({ timeout: 500 });
	}).toPass();
	await expect(status(page)).toHaveText(/^\d+ results$/);
	await expect(await active(page)).toHaveText(/Carrot/);
	await page.keyboard.press("ArrowDown");
	await expect(await active(page)).toHaveText(/Double umbel/);
	await page.keyboard.press("ArrowUp");
	await page.keyboard.press("Enter");
	await expect(dialog(page)).toBeHidden();
	await expect(page).toHaveURL(/preset=carrot/);
	await expect(studio.notices).toContainText("Plant: Carrot");
	await page.keyboard.press("Control+z");
	await expect(studio.fingerprint).toHaveText(before);
});

test("a setting is shown in its group with the focus on its control, and an action runs", async ({ page }) => {
	const studio = await opened(page, "?v=2&preset=cylindrical");
	await page.keyboard.press("Escape");
	await expect(dialog(page)).toBeHidden();
	const group = page.locator("details[data-group=branching]");
	if ((await group.getAttribute("open")) !== null) await group.locator("summary").click();
	await page.keyboard.press("Control+k");
	await field(page).fill("yaw");
	await page.keyboard.press("Enter");
	await expect(studio.slider("Yaw")).toBeFocused();
	await expect(studio.slider("Yaw")).toBeInViewport();
	await expect(group).toHaveAttribute("open");
	await page.keyboard.press("Control+k");
	await field(page).fill("dark mode");
	await page.keyboard.press("Enter");
	await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
	await expect(studio.notices).toContainText("Dark theme");
	// The entry that was run last comes first, and closing gives the focus back.
	await studio.slider("Length").focus();
	await page.keyboard.press("Control+k");
	await expect(dialog(page).getByRole("group", { name: "Recent" }).getByRole("option").first()).toHaveText(
		/Light theme/,
	);
	await page.keyboard.press("Control+k");
	await expect(dialog(page)).toBeHidden();
	await expect(studio.slider("Length")).toBeFocused();
});

test("tools, files, languages and pages of the help are run from the palette", { tag: "@long" }, async ({
	page,
	context,
}) => {
	const studio = await opened(page);
	await field(page).fill("grammar");
	await option(page, "Grammar G").click();
	await expect(page.getByRole("textbox", { name: "Grammar" })).toBeVisible();
	await page.keyboard.press("Control+k");
	await field(page).fill("stl");
	const download = page.waitForEvent("download");
	await option(page, /^Download .*STL/i)
		.first()
		.click();
	expect((await download).suggestedFilename()).toMatch(/\.stl$/);
	await page.keyboard.press("Control+k");
	const opening = context.waitForEvent("page");
	await field(page).fill("glossary");
	await option(page, /^Glossary/).click();
	await expect(await opening).toHaveURL(/docs\/glossary\.html$/);
	await page.bringToFront();
	await page.keyboard.press("Control+k");
	await field(page).fill("Open");
	const choosing = page.waitForEvent("filechooser");
	await option(page, /^Open…/).click();
	await choosing;
	await page.keyboard.press("Control+k");
	await field(page).fill("wind");
	await option(page, /^Wind/).click();
	await expect(studio.button("Wind on/off")).toHaveAttribute("aria-pressed", "true");
	await expect(studio.notices).toContainText("Wind on");
	await page.keyboard.press("Control+k");
	await field(page).fill("french");
	await option(page, /Français/).click();
	await expect(page.locator("html")).toHaveAttribute("lang", "fr");
});

test("nothing found is announced, and the palette fits a phone and works by touch", { tag: "@long" }, async ({
	browser,
}) => {
	const phone = await browser.newContext({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
	await phone.addInitScript(withoutHints);
	const page = await phone.newPage();
	const studio = await opened(page);
	// There is no keyboard: shortcuts are not shown, and a button closes the palette.
	await expect(option(page, /^New variation/)).toBeVisible();
	await expect(dialog(page).locator("kbd:visible")).toHaveCount(0);
	await dialog(page).getByRole("button", { name: "Close" }).tap();
	await expect(dialog(page)).toBeHidden();
	await page.getByRole("button", { name: "Search everything" }).tap();
	await field(page).fill("plum pudding");
	await expect(status(page)).toHaveText("Nothing found");
	await expect(dialog(page).getByText("Nothing matches “plum pudding”")).toBeVisible();
	await expect(field(page)).toHaveAttribute("aria-expanded", "false");
	await field(page).fill("riesling");
	const heights = await dialog(page)
		.getByRole("option")
		.evaluateAll((options) => options.map((each) => each.getBoundingClientRect().height));
	expect(Math.min(...heights)).toBeGreaterThanOrEqual(44);
	expect(await studio.overflow()).toBeLessThanOrEqual(0);
	await option(page, /^Riesling/).tap();
	await expect(page).toHaveURL(/preset=riesling/);
	await phone.close();
});

test("an empty field lists the plants that were open lately, as the home page does, and opens one", async ({
	page,
}) => {
	const studio = await opened(page, "?v=2&preset=riesling&l=150");
	await page.keyboard.press("Escape");
	await page.goto("./");
	await expect(page.locator(".recent-plant b")).toHaveText(["Riesling (edited)"]);
	await opened(page, "?v=2&preset=lychee");
	const recent = dialog(page).getByRole("group", { name: "Recent plants" }).getByRole("option");
	await expect(recent).toHaveText([/Riesling \(edited\) (edited|opened) just now/]);
	await recent.click();
	await expect(page).toHaveURL(/preset=riesling.*l=150/);
	await expect(studio.slider("Length")).toHaveValue("150");
});
