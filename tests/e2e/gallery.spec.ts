import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const search = (page: Page) => page.getByRole("searchbox", { name: "Search presets" });
const kind = (page: Page) => page.getByRole("combobox", { name: "Kind of preset" });
const count = (page: Page) => page.locator(".find [role=status]");
const shown = (page: Page) => page.locator(".preset");

/** The app with every model's presets in its gallery. */
async function opened(page: Page, search?: string): Promise<StudioPage> {
	const studio = await new StudioPage(page).open(search);
	await expect(page.locator("[data-preset=twin]")).toBeAttached();
	return studio;
}

test("presets are searched by what they are called and said to be, and the count is told", async ({ page }) => {
	const studio = await opened(page);
	const all = await shown(page).count();
	await expect(count(page)).toHaveText(`${all} presets`);
	await search(page).fill("gewurz");
	await expect(shown(page)).toHaveText(["Gewürztraminer"]);
	await expect(count(page)).toHaveText("1 preset");
	await search(page).fill("blue-black cone");
	await expect(count(page)).not.toHaveText(`${all} presets`);
	for (const preset of await shown(page).all()) await expect(preset).toHaveAttribute("title", /blue-black|cone/);
	await studio.regrown(() => shown(page).first().click());
	await expect(page).toHaveURL(/preset=/);
	await expect(search(page)).toHaveValue("blue-black cone");
});

test("nothing found says so, and Escape or a button brings all of them back", { tag: "@long" }, async ({ page }) => {
	await opened(page);
	const all = await shown(page).count();
	await search(page).fill("plum pudding");
	await expect(shown(page)).toHaveCount(0);
	await expect(count(page)).toHaveText("No preset found");
	await expect(page.getByText("No preset has that in its name or description.")).toBeVisible();
	await page.getByRole("button", { name: "Show all" }).click();
	await expect(shown(page)).toHaveCount(all);
	await expect(search(page)).toBeFocused();
	await search(page).fill("pudding");
	await search(page).press("Escape");
	await expect(search(page)).toHaveValue("");
	await expect(shown(page)).toHaveCount(all);
});

test("one kind is shown alone, and searched alone", { tag: "@long" }, async ({ page }) => {
	await opened(page);
	await expect(page.locator("section[data-model=leaf] h2").first()).toContainText("preview");
	await expect(page.locator("section[data-model=bunch] h2").first()).not.toContainText("preview");
	await kind(page).selectOption("Other fruits");
	await expect(shown(page)).toHaveCount(5);
	await expect(page.getByRole("region", { name: "Varieties" })).toHaveCount(0);
	await search(page).fill("lych");
	await expect(shown(page)).toHaveText([/^\s*Lychee\s*Fig\. 16\(c\)\s*$/]);
	await kind(page).press("Escape");
	await expect(kind(page)).toHaveValue("");
	await expect(search(page)).toHaveValue("");
});

test("the keyboard goes from the field to the presets and from one to the next; the strip is one stop", async ({
	page,
}) => {
	const studio = await opened(page);
	await search(page).focus();
	await page.keyboard.press("Tab");
	await page.keyboard.press("Tab");
	await expect(page.locator("[data-preset=long-conical]")).toBeFocused();
	await page.keyboard.press("ArrowRight");
	await expect(page.locator("[data-preset=cylindrical]")).toBeFocused();
	await page.keyboard.press("End");
	await expect(shown(page).last()).toBeFocused();
	await page.keyboard.press("Home");
	await expect(shown(page).first()).toBeFocused();
	await page.keyboard.press("Escape");
	await expect(search(page)).toBeFocused();
	await page.keyboard.type("duku");
	await page.keyboard.press("ArrowDown");
	await expect(page.locator("[data-preset=duku]")).toBeFocused();
	await studio.regrown(() => page.keyboard.press("Enter"));
	await expect(page).toHaveURL(/preset=duku/);
	await search(page).fill("riesling");
	await studio.regrown(() => search(page).press("Enter"));
	await expect(page).toHaveURL(/preset=riesling/);
});

test("typing in the field is typing: no letter is a shortcut, and undo is the field's", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await opened(page);
	await search(page).pressSequentially("snot");
	await expect(studio.button("Show stems only")).toHaveAttribute("aria-pressed", "false");
	await expect(studio.button("Undo")).toBeDisabled();
	await expect(page).not.toHaveURL(/seed=/);
});

for (const [words, width, height] of [
	["on a phone", 390, 844],
	["at 200 %", 640, 400],
] as const) {
	test(`presets are found ${words}`, { tag: "@long" }, async ({ page }) => {
		await page.setViewportSize({ width, height });
		const studio = await opened(page);
		await search(page).fill("syrah");
		await expect(shown(page)).toHaveText(["Syrah"]);
		await studio.regrown(() => shown(page).first().click());
		await expect(page).toHaveURL(/preset=syrah/);
		expect(await studio.overflow()).toBeLessThanOrEqual(0);
	});
}

test("pictures come when they are near to being seen", async ({ page }) => {
	const requested = new Set<string>();
	page.on("request", (request) => {
		if (/\/gallery\//.test(request.url())) requested.add(request.url());
	});
	await page.setViewportSize({ width: 390, height: 844 });
	await opened(page);
	await page.waitForLoadState("networkidle");
	expect(requested.size).toBeGreaterThan(0);
	expect(requested.size).toBeLessThan(await shown(page).count());
});
