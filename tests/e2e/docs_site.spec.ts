/** The documentation site of the built app: reached from the help, searched, and with plants that grow. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Page } from "@playwright/test";
import { grown } from "./element_page";
import { expect, test } from "./fixtures";
import { Site } from "./site";
import { StudioPage } from "./studio_page";

const dist = fileURLToPath(new URL("../../dist", import.meta.url));
const PHONE = { width: 390, height: 844 };

/** Searches, and follows the result that leads to a page. */
async function followSearch(page: Page, words: string, address: string): Promise<void> {
	await page.getByRole("combobox").fill(words);
	await page.locator(`[role=option][href*="${address}"]`).first().click();
	await expect(page).toHaveURL(new RegExp(`/docs/${address}`));
}

for (const [name, viewport] of [
	["desktop", { width: 1280, height: 800 }],
	["phone", PHONE],
] as const) {
	test.describe(`at ${name} size`, () => {
		test.use({ viewport });

		test("the help leads to the documentation, whose search leads to a page with a plant", async ({
			page,
			context,
			complaints,
		}) => {
			await new StudioPage(page).open();
			await page.getByRole("button", { name: "Help" }).click();
			const opened = context.waitForEvent("page");
			await page.getByRole("link", { name: /^Documentation/ }).click();
			const docs = await opened;
			complaints.listenTo(docs);
			await expect(docs).toHaveURL(/\/docs\/$/);
			await followSearch(docs, "USDZ", "export.html");
			await followSearch(docs, "leaf_kind", "models/growth/parameters.html");
			await followSearch(docs, "oak", "models/tree/tree.html");
			await docs.locator("panicle-specimen").scrollIntoViewIfNeeded();
			await grown(docs);
			const width = await docs.evaluate(() => document.documentElement.scrollWidth);
			expect(width).toBeLessThanOrEqual(viewport.width);
		});
	});
}

test("on a phone the pages are listed behind a button", async ({ page }) => {
	await page.setViewportSize(PHONE);
	await page.goto("/docs/");
	const pages = page.getByRole("navigation", { name: "Pages" });
	await expect(pages).toBeHidden();
	await page.getByRole("button", { name: "Pages" }).click();
	await pages.getByText("Stands of plants", { exact: true }).click();
	await pages.getByRole("link", { name: "The plan language" }).click();
	await expect(page).toHaveURL(/models\/stand\/language\.html$/);
});

test("works in any folder, with the policy sent as a header", async ({ page }) => {
	const site = new Site("docs");
	const address = await site.start();
	try {
		await page.goto(`${address}docs/models/flower/flower.html`);
		await followSearch(page, "response header", "hosting.html");
		await page.getByRole("link", { name: "Open the app" }).click();
		await expect(page).toHaveURL(address);
	} finally {
		await page.goto("about:blank");
		await site.stop();
	}
});

test("is not part of the offline app", () => {
	const worker = readFileSync(join(dist, "service-worker.js"), "utf8");
	expect(worker).toContain("embed.html");
	expect(worker).not.toContain("docs/");
});
