import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const dialogOf = (page: Page) => page.getByRole("dialog", { name: "Presets" });
const search = (page: Page) => page.getByRole("searchbox", { name: "Search presets" });
const count = (page: Page) => dialogOf(page).getByRole("status");
const cards = (page: Page) => dialogOf(page).locator(".preset");
const chip = (page: Page, name: string) => dialogOf(page).getByRole("button", { name, exact: true });
const strip = (page: Page) => page.locator(".strip");

test("the bar names family and preset, and a family grows its first plant, one step to undo", async ({ page }) => {
	await page.setViewportSize({ width: 1280, height: 700 });
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	const family = page.getByRole("banner").getByRole("combobox", { name: "Family" });
	await expect(family).toHaveValue("grapes");
	await expect(page.getByRole("banner").getByRole("button", { name: "Lychee" })).toBeVisible();
	await expect(page.getByText("edited", { exact: true })).toHaveCount(0);
	await studio.regrown(() => studio.slider("Length").press("PageDown"));
	await expect(page.getByText("edited", { exact: true })).toBeVisible();
	await studio.button("Undo").click();
	await studio.regrown(() => family.selectOption("Leaves"));
	await expect(page).toHaveURL(/model=leaf/);
	await studio.presetsListed();
	await expect(strip(page).locator("section[data-model=bunch]")).toHaveCount(0);
	await studio.regrown(() => studio.button("Undo").click());
	await expect(page).toHaveURL(/preset=lychee/);
	await expect(family).toHaveValue("grapes");
	await expect(strip(page).getByRole("group", { name: "Other fruits" })).toBeVisible();
});

test("the strip holds one family without the papers’ figures, moves by wheel, and is one stop of the keyboard", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&model=growth&preset=oak");
	await studio.presetsListed();
	await expect(strip(page).getByRole("group", { name: "Species" })).toBeVisible();
	await expect(strip(page).getByRole("group", { name: /Table 1|Figures/ })).toHaveCount(0);
	await expect(strip(page).locator("[data-model=growth] [data-preset=oak]")).toHaveAttribute("aria-current", "true");
	const before = await strip(page).evaluate((element) => element.scrollLeft);
	await strip(page).hover();
	await page.mouse.wheel(0, 400);
	await expect.poll(() => strip(page).evaluate((element) => element.scrollLeft)).toBeGreaterThan(before + 100);
	await strip(page).locator("[data-model=growth] [data-preset=oak]").focus();
	await page.keyboard.press("ArrowRight");
	await expect(strip(page).locator("[data-model=growth] [data-preset=olive]")).toBeFocused();
	await page.keyboard.press("Escape");
	await expect(studio.button("Browse presets")).toBeFocused();
});

test("the gallery is searched, best match first; Escape empties the search, and Enter chooses the first", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open();
	await studio.presetsListed();
	await page.keyboard.press("/");
	await expect(search(page)).toBeFocused();
	await search(page).fill("gewurz");
	await expect(cards(page)).toHaveText([/Gewürztraminer/]);
	await expect(count(page)).toHaveText("1 preset");
	await search(page).press("Escape");
	await expect(search(page)).toHaveValue("");
	await expect(dialogOf(page)).toBeVisible();
	await search(page).fill("figure 11");
	await expect(cards(page).first()).toHaveText(/Long conical/);
	await search(page).fill("plum pudding");
	await expect(cards(page)).toHaveCount(0);
	await expect(page.getByText(/^No presets match “/)).toBeVisible();
	await page.getByRole("button", { name: "Show all" }).click();
	await expect(cards(page).first()).toBeVisible();
	await search(page).fill("riesling");
	await studio.regrown(() => search(page).press("Enter"));
	await expect(dialogOf(page)).toBeHidden();
	await expect(page).toHaveURL(/preset=riesling/);
});

test("families, methods, favourites and recent presets filter the gallery; papers are folded", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=growth&preset=oak");
	await studio.browse();
	await expect(chip(page, "Trees")).toHaveAttribute("aria-pressed", "true");
	await expect(dialogOf(page).locator("[data-preset=oak][aria-current=true]")).toBeInViewport();
	await expect(dialogOf(page).locator("[data-preset=table-1-hat]")).toBeHidden();
	await dialogOf(page).getByText("From research papers").click();
	await expect(dialogOf(page).locator("[data-preset=table-1-hat]")).toBeVisible();
	await chip(page, "Particle systems").click();
	await expect(dialogOf(page).locator("section:not([data-model=tree])")).toHaveCount(0);
	await chip(page, "Flowers").click();
	await dialogOf(page).getByRole("button", { name: "Add Poppy to the favourites" }).click();
	await studio.regrown(() => dialogOf(page).locator("[data-preset=tulip]").click());
	await page.reload();
	await studio.browse();
	await chip(page, "Favourites").click();
	await expect(cards(page)).toHaveText([/Poppy/]);
	await chip(page, "Recent").click();
	await expect(cards(page).first()).toHaveText(/Tulip/);
	await chip(page, "Favourites").click();
	await dialogOf(page).getByRole("button", { name: "Remove Poppy from the favourites" }).click();
	await expect(chip(page, "Favourites")).toHaveCount(0);
});

for (const [words, width, height] of [
	["on a phone", 390, 844],
	["at 200 %", 640, 400],
] as const) {
	test(`a family and a preset are found ${words}`, { tag: "@long" }, async ({ page }) => {
		await page.setViewportSize({ width, height });
		const studio = await new StudioPage(page).open();
		await studio.browse();
		await search(page).fill("syrah");
		await expect(cards(page)).toHaveText([/Syrah/]);
		await studio.regrown(() => cards(page).first().click());
		await expect(page).toHaveURL(/preset=syrah/);
		await studio.regrown(() => page.locator(".find").getByRole("combobox", { name: "Family" }).selectOption("Roots"));
		await expect(page).toHaveURL(/model=root/);
		expect(await studio.overflow()).toBeLessThanOrEqual(0);
	});
}

test("letters typed into a field are no shortcuts, and undo there is the field’s", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open();
	await page.getByRole("textbox", { name: "Seed" }).focus();
	await page.keyboard.type("snot/");
	await expect(dialogOf(page)).toBeHidden();
	await expect(studio.button("Undo")).toBeDisabled();
	await expect(page).not.toHaveURL(/seed=/);
});

test("pictures come when they are near to being seen", async ({ page }) => {
	const requested = new Set<string>();
	page.on("request", (request) => {
		if (/\/gallery\//.test(request.url())) requested.add(request.url());
	});
	await page.setViewportSize({ width: 390, height: 844 });
	const studio = await new StudioPage(page).open();
	await studio.presetsListed();
	await page.waitForLoadState("networkidle");
	expect(requested.size).toBeGreaterThan(0);
	expect(requested.size).toBeLessThan(await page.locator(".strip .preset").count());
});

test("titles in the strip keep apart", async ({ page }) => {
	await page.setViewportSize({ width: 1280, height: 800 });
	await new StudioPage(page).open("?v=2&model=flower&preset=dandelion");
	await expect(page.locator(".strip .preset").nth(8)).toBeVisible();
	const gaps = await page.locator(".strip ul").evaluateAll((lists) =>
		lists.flatMap((list) => {
			const boxes = [...list.querySelectorAll(".preset")].map((preset) => {
				const range = document.createRange();
				const words = [...preset.childNodes].filter(
					({ nodeType, textContent }) => nodeType === 3 && textContent?.trim(),
				);
				range.selectNodeContents(words[0]);
				return range.getBoundingClientRect();
			});
			return boxes.slice(1).map(({ left }, i) => left - boxes[i].right);
		}),
	);
	expect(gaps.length).toBeGreaterThan(20);
	expect(Math.min(...gaps)).toBeGreaterThanOrEqual(8);
});

test("while a plant of another model loads, the last one is dimmed without its caption, and progress names the next", async ({
	page,
}) => {
	await new StudioPage(page).open("?v=2&preset=cylindrical");
	await page.route("**/*.wasm", async (route) => {
		await new Promise((resolve) => setTimeout(resolve, 1500));
		await route.continue();
	});
	const caption = page.locator("panicle-stage .caption h2");
	await expect(caption).toHaveText("Cylindrical");
	await page
		.getByRole("navigation", { name: "Presets" })
		.or(page.getByRole("group", { name: "Plant" }))
		.getByLabel("Family")
		.filter({ visible: true })
		.selectOption("roots");
	await expect(page.getByRole("status").filter({ hasText: "Growing: Tap root" })).toBeVisible();
	const view = page.locator(".stage-surface");
	await expect(view).toHaveCSS("opacity", "0.25");
	await expect(caption).toBeHidden();
	await expect(caption).toHaveText("Tap root");
	await expect(view).toHaveCSS("opacity", "1");
});
