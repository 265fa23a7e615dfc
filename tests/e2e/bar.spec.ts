import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** Sizes of windows, with both ends of the ranges for which the bar has a layout of its own. */
const SIZES = [
	[320, 640],
	[380, 740],
	[381, 740],
	[412, 915],
	[480, 800],
	[481, 800],
	[720, 900],
	[721, 900],
	[844, 390],
	[960, 700],
	[1140, 700],
	[1250, 800],
	[1251, 800],
	[1440, 900],
] as const;

/** The controls of the bar that overlap another one or reach beyond the window, by their names. */
const misplaced = (page: Page) =>
	page.evaluate(() => {
		const isHidden = (element: Element | null) => element !== null && getComputedStyle(element).clipPath !== "none";
		const shown = [...document.querySelectorAll<HTMLElement>(".bar :is(a, button, select, input)")]
			.filter((element) => element.checkVisibility() && !isHidden(element.closest(".wordmark")))
			.map((element) => ({ name: element.ariaLabel ?? element.innerText, box: element.getBoundingClientRect() }));
		const overlap = (a: DOMRect, b: DOMRect) =>
			a.left < b.right - 0.5 && b.left < a.right - 0.5 && a.top < b.bottom - 0.5 && b.top < a.bottom - 0.5;
		return shown.flatMap(({ name, box }, at) => {
			const other = shown.slice(at + 1).find((each) => overlap(box, each.box));
			const isOutside = box.left < -0.5 || box.right > innerWidth + 0.5;
			return other || isOutside ? [`${name} ${other ? `over ${other.name}` : "outside"}`] : [];
		});
	});

/** The buttons beside the strip whose words are wider than the button, or that are wider than their column. */
const tooWide = (page: Page) =>
	page.locator(".find").evaluate((column) =>
		[...column.querySelectorAll<HTMLElement>("button, select")]
			.filter((element) => {
				const words = element.querySelector(".words") ?? element;
				const [inner, outer, all] = [words, element, column].map((each) => each.getBoundingClientRect());
				return (
					outer.right > all.right + 0.5 ||
					inner.right > outer.right + 0.5 ||
					element.scrollWidth > element.clientWidth + 1
				);
			})
			.map((element) => element.innerText),
	);

for (const language of ["en", "fr"])
	test(`in ${language} all buttons of the bar and beside the strip have room, in windows of any size`, async ({
		page,
	}) => {
		await page.addInitScript((tag) => localStorage.setItem("panicle.ui", JSON.stringify({ language: tag })), language);
		await new StudioPage(page).open("?v=2&model=growth&preset=oak&steps=4");
		for (const [width, height] of SIZES)
			await test.step(`${width} × ${height}`, async () => {
				await page.setViewportSize({ width, height });
				await expect.poll(() => misplaced(page)).toEqual([]);
				expect(await tooWide(page)).toEqual([]);
			});
	});

test.describe("by touch", () => {
	test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

	test("a button of the bar opens the search of everything, which changes the theme on a phone", async ({ page }) => {
		await page.emulateMedia({ colorScheme: "light" });
		const studio = await new StudioPage(page).open("?v=2&preset=redcurrant&count=12");
		await studio.button("Search everything").tap();
		const dialog = page.getByRole("dialog", { name: "Search everything" });
		await dialog.getByRole("combobox").fill("dark");
		await dialog.getByRole("option", { name: "Dark theme" }).tap();
		await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
		await expect(dialog).toBeHidden();
	});
});
