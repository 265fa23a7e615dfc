import { readFileSync } from "node:fs";
import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** Chooses a language before the page loads, as the page remembers it. */
const choose = (page: Page, language: string) =>
	page.addInitScript((tag) => localStorage.setItem("panicle.ui", JSON.stringify({ language: tag })), language);

/** Labels that are cut off: their text is wider or higher than the box that clips it. Scrolling boxes clip nothing. */
const clipped = (page: Page) =>
	page.evaluate(() => {
		const shown = [
			...document.querySelectorAll<HTMLElement>("button, label, summary, h1, h2, h3, legend, dt, dd, p, select"),
		].filter((element) => element.checkVisibility({ visibilityProperty: true }) && element.closest(".unseen") === null);
		return shown.flatMap((element) => {
			const style = getComputedStyle(element);
			// An ellipsis shows that a text goes on; its whole is the title of the element.
			const cuts = /hidden|clip/.test(`${style.overflowX} ${style.overflowY}`) && style.textOverflow !== "ellipsis";
			const isCut = element.scrollWidth > element.clientWidth + 1 || element.scrollHeight > element.clientHeight + 2;
			const { left, right, width } = element.getBoundingClientRect();
			// Texts for screen readers alone.
			if (width <= 1 || style.clipPath !== "none") return [];
			const scrolls = element.closest(".strip, .sheet, .panel, [data-scrolls], .life-bar, .stage-tools, dialog");
			const isOutside = !scrolls && (left < -1 || right > innerWidth + 1);
			return (cuts && isCut) || isOutside ? [`${element.localName}: ${element.textContent?.trim().slice(0, 60)}`] : [];
		});
	});

const sideways = (page: Page) => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

for (const language of ["en-XA", "ar-XB", "fr"]) {
	for (const [width, height] of [
		[1440, 900],
		[390, 844],
	]) {
		test(`in ${language} at ${width} × ${height} no text is clipped and nothing scrolls sideways`, async ({ page }) => {
			await choose(page, language);
			await page.setViewportSize({ width, height });
			for (const query of ["?v=2&preset=merlot", "?v=2&model=flower&preset=tulip"]) {
				await new StudioPage(page).open(query);
				expect(await clipped(page)).toEqual([]);
				expect(await sideways(page)).toBeLessThanOrEqual(0);
			}
		});
	}
}

test("in a script from right to left the panel is on the left, and the view keeps working", async ({ page }) => {
	await choose(page, "ar-XB");
	const studio = await new StudioPage(page).open("?v=2&preset=merlot");
	await expect(page.locator("html")).toHaveAttribute("dir", "rtl");
	const [panel, stage] = [
		await page.locator(".panel").boundingBox(),
		await page.locator("panicle-stage").boundingBox(),
	];
	if (!panel || !stage) throw new Error("no panel or no view");
	expect(panel.x).toBeLessThan(stage.x);
	const slider = page.locator("input[type=range]").first();
	await studio.regrown(() => slider.press("PageUp"));
});

test.describe("in a browser in French", () => {
	test.use({ locale: "fr-CA" });

	test("the page is in French, and keeps a language that is chosen", async ({ page }) => {
		await new StudioPage(page).open("?v=2&preset=merlot");
		await expect(page.locator("html")).toHaveAttribute("lang", "fr");
		await expect(page.getByRole("button", { name: "Partager" })).toBeVisible();
		await page.getByRole("button", { name: /^Aide/ }).click();
		await page.getByRole("combobox", { name: "Langue" }).selectOption({ label: "English" });
		await expect(page.locator("html")).toHaveAttribute("lang", "en");
		await expect(page.getByRole("button", { name: "Share" })).toBeVisible();
		expect(page.url()).toContain("preset=merlot");
	});
});

test("in English no catalogue of another language is fetched", async ({ page }) => {
	const fetched: string[] = [];
	page.on("request", (request) => fetched.push(new URL(request.url()).pathname));
	await new StudioPage(page).open();
	expect(fetched.filter((path) => /\/fr[.-]|catalogue|pseudo/.test(path))).toEqual([]);
	expect(fetched.length).toBeGreaterThan(5);
});

test("the font of titles has every letter of the French texts", async ({ page }) => {
	const texts = readFileSync("web/src/locale/fr.json", "utf8");
	const letters = [...new Set(texts.match(/[A-Za-zÀ-ÿŒœŸ]/g))].sort();
	expect(letters).toEqual(expect.arrayContaining(["è", "ô", "œ", "É"]));
	await new StudioPage(page).open("?v=2&preset=merlot");
	const missing = await page.evaluate(async (all) => {
		const context = new OffscreenCanvas(1, 1).getContext("2d") as OffscreenCanvasRenderingContext2D;
		const styles = ["500 100px", "italic 400 100px"];
		await Promise.all(styles.map((style) => document.fonts.load(`${style} "EB Garamond"`)));
		// A letter that the font lacks has the width of the letter in the fallback, whichever that is.
		const width = (style: string, fonts: string, letter: string) => {
			context.font = `${style} ${fonts}`;
			return context.measureText(letter).width;
		};
		return styles.flatMap((style) =>
			all.filter(
				(letter) =>
					width(style, '"EB Garamond", monospace', letter) !== width(style, '"EB Garamond", sans-serif', letter),
			),
		);
	}, letters);
	expect(missing).toEqual([]);
});
