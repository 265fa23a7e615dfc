import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Page } from "@playwright/test";
import { byKind, firstLoad } from "../bench/sizes.mjs";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const dist = fileURLToPath(new URL("../../dist", import.meta.url));
const family = (page: Page, name: string) => page.getByRole("link", { name: new RegExp(`^${name}`) });

test("an address without a plant opens the home page; a family opens its plant, and Back returns", async ({ page }) => {
	await page.goto("./");
	await expect(page.getByRole("heading", { level: 1 })).toHaveText(/^Grow grapes, trees, flowers and gardens/);
	await expect(page).toHaveTitle("Panicle: grow plants in your browser");
	await expect(page.locator(".family")).toHaveCount(8);
	const broken = await page
		.locator(".family img")
		.evaluateAll(async (pictures: HTMLImageElement[]) =>
			(await Promise.allSettled(pictures.map((picture) => picture.decode()))).filter(
				({ status }) => status === "rejected",
			),
		);
	expect(broken).toEqual([]);
	await family(page, "Roots").click();
	const studio = new StudioPage(page);
	await expect(studio.fingerprint).toHaveText(/^[0-9a-f]{16}$/);
	await expect(page).toHaveURL(/model=root$/);
	await page.goBack();
	await expect(family(page, "Grapes")).toBeVisible();
});

test("the home page needs under 60 kB of code, no core and nothing of three.js", async ({ page }) => {
	await page.goto("./");
	await expect(family(page, "Trees")).toBeVisible();
	await page.waitForLoadState("networkidle");
	const requested = await page.evaluate(() =>
		performance.getEntriesByType("resource").map(({ name }) => new URL(name).pathname.slice(1)),
	);
	const files = firstLoad(dist, ["index.html", ...new Set(requested)]);
	const sizes = byKind(files);
	expect(sizes.core).toBe(0);
	expect(sizes.code).toBeLessThan(60_000);
	const scripts = files
		.filter(({ path }) => path.endsWith(".js"))
		.map(({ path }) => readFileSync(join(dist, path), "utf8"));
	expect(scripts.length).toBeGreaterThan(1);
	expect(scripts.filter((script) => script.includes("webgl2"))).toEqual([]);
});

test("title, description and picture of the page are those of what is shown", async ({ page }) => {
	const meta = (key: string) => page.locator(`meta[property="og:${key}"], meta[name="${key}"]`).first();
	await page.goto("./");
	await expect(meta("image")).toHaveAttribute("content", /share\.jpg$/);
	await expect(meta("description")).toHaveAttribute("content", /^Grow grapes, trees, flowers and gardens/);
	await new StudioPage(page).open("?v=2&preset=lychee");
	await expect(page).toHaveTitle("Lychee 1 · Panicle");
	await expect(meta("title")).toHaveAttribute("content", "Lychee 1 · Panicle");
	await expect(meta("description")).toHaveAttribute("content", /large fruits/);
	await expect(meta("image")).toHaveAttribute("content", /^http.*\/gallery\/bunch\/lychee-light\.webp$/);
});

test("the search of the home page finds plants of all families, and Enter opens the first", async ({ page }) => {
	await page.goto("./");
	const search = page.getByRole("searchbox", { name: "Search all plants" });
	await search.fill("lsystem");
	await expect(page.getByRole("region", { name: "Plants found" }).getByRole("link").first()).toBeVisible();
	await search.fill("vineyard");
	await expect(page.locator(".found-plant").first()).toContainText("A vineyard");
	await search.fill("carrot");
	await expect(page.locator(".found-plant").first()).toContainText("Carrot");
	await search.press("Enter");
	await expect(page).toHaveURL(/model=root&preset=carrot$/);
	await expect(new StudioPage(page).fingerprint).toHaveText(/^[0-9a-f]{16}$/);
});

test("Ctrl+K and / move the focus to the search of the home page, and Ctrl+K selects its text", async ({ page }) => {
	await page.goto("./");
	const search = page.getByRole("searchbox", { name: "Search all plants" });
	await expect(search).toHaveAttribute("aria-keyshortcuts", "Control+K Meta+K /");
	await family(page, "Trees").focus();
	await page.keyboard.press("/");
	await expect(search).toBeFocused();
	await expect(search).toHaveValue("");
	await search.pressSequentially("1/2");
	await expect(search).toHaveValue("1/2");
	await family(page, "Trees").focus();
	await page.keyboard.press("Control+k");
	await expect(search).toBeFocused();
	await page.keyboard.type("oak");
	await expect(search).toHaveValue("oak");
	// In the studio, the same keys open its own searches.
	await family(page, "Roots").click();
	await expect(new StudioPage(page).fingerprint).toHaveText(/^[0-9a-f]{16}$/);
	await page.keyboard.press("Control+k");
	await expect(page.getByRole("combobox", { name: "Search plants, settings, actions and help" })).toBeFocused();
});

test("a file opened on the home page is shown in the studio", async ({ page }) => {
	await page.goto("./");
	const [chooser] = await Promise.all([
		page.waitForEvent("filechooser"),
		page.getByRole("button", { name: "Open file…" }).click(),
	]);
	const [grammar] = readdirSync("wasm-core/grammars/growth").filter((file) => file === "birch.growth");
	await chooser.setFiles(join("wasm-core/grammars/growth", grammar));
	await expect(page).toHaveURL(/model=growth/);
	await expect(new StudioPage(page).fingerprint).toHaveText(/^[0-9a-f]{16}$/);
});

for (const [words, width, height] of [
	["on a phone", 390, 844],
	["in 320 pixels", 320, 500],
] as const) {
	test(`the home page fits ${words}, in dark colours too`, { tag: "@long" }, async ({ page }) => {
		await page.setViewportSize({ width, height });
		await page.emulateMedia({ colorScheme: "dark" });
		await page.goto("./");
		await expect(family(page, "Topiary")).toBeAttached();
		expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
		await page.getByRole("button", { name: "Light theme" }).click();
		await expect(page.locator("html")).toHaveAttribute("data-theme", "light");
	});
}

for (const language of ["en", "fr"]) {
	test(`on a phone, in ${language}, the header is one row, and the search shows its whole example`, async ({
		page,
	}) => {
		await page.addInitScript((tag) => localStorage.setItem("panicle.ui", JSON.stringify({ language: tag })), language);
		await page.setViewportSize({ width: 390, height: 844 });
		await page.goto("./");
		await expect(page.locator(".family")).toHaveCount(8);
		const middles = await page.locator(".home-bar :is(.wordmark, nav .button)").evaluateAll((links) =>
			links.map((link) => {
				const { top, bottom } = link.getBoundingClientRect();
				return (top + bottom) / 2;
			}),
		);
		expect(middles.length).toBe(5);
		expect(Math.max(...middles) - Math.min(...middles)).toBeLessThan(4);
		const [example, room] = await page.locator(".home-search input").evaluate((field: HTMLInputElement) => {
			const context = new OffscreenCanvas(1, 1).getContext("2d") as OffscreenCanvasRenderingContext2D;
			context.font = getComputedStyle(field).font;
			return [context.measureText(field.placeholder).width, field.clientWidth];
		});
		expect(example).toBeGreaterThan(100);
		expect(example).toBeLessThanOrEqual(room);
	});
}

test("the search tells plants with equal titles apart by a second line", async ({ page }) => {
	await page.goto("./");
	await page.getByRole("searchbox", { name: "Search all plants" }).fill("oak");
	await expect(page.locator(".found-plant").filter({ hasText: /^\s*Oak\s/ })).toHaveText([
		/Trees · Species · Growth grammars/,
		/Trees · Particle systems/,
		/Leaves · Pinnate/,
	]);
});
