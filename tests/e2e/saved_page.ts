/** The dialog of saved plants, for tests. */
import { readFileSync } from "node:fs";
import type { Locator, Page } from "@playwright/test";
import { expect } from "./fixtures";

export const dialog = (page: Page) => page.getByRole("dialog", { name: "My plants" });
export const cards = (page: Page) => dialog(page).locator("[data-saved]");
export const names = (page: Page) => dialog(page).locator("[data-saved] .name");
export const status = (page: Page) => dialog(page).locator(".said [role=status]");
export const inDialog = (page: Page, name: string | RegExp): Locator =>
	dialog(page).getByRole("button", { name, exact: typeof name === "string" });

/** Opens the dialog by its button. */
export async function openSaved(page: Page): Promise<void> {
	await page.getByRole("button", { name: "My plants" }).click();
	await expect(dialog(page)).toBeVisible();
}

export async function save(page: Page, name?: string): Promise<void> {
	if (name !== undefined) await dialog(page).getByLabel("Name", { exact: true }).fill(name);
	await inDialog(page, /^Save this/).click();
	await expect(status(page)).toContainText("Saved as");
}

/** The text of an exported file. */
export async function exported(page: Page, button = "Export all"): Promise<string> {
	const downloading = page.waitForEvent("download");
	await inDialog(page, button).click();
	const download = await downloading;
	expect(download.suggestedFilename()).toMatch(/^saved-\d{4}-\d\d-\d\d\.panicle\.json$/);
	return readFileSync(await download.path(), "utf8");
}

export async function imported(page: Page, name: string, text: string): Promise<void> {
	const choosing = page.waitForEvent("filechooser");
	await inDialog(page, "Import…").click();
	await (await choosing).setFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });
}

/** A file of specimens without pictures: Vine 0 is the oldest. */
export function libraryOf(count: number): string {
	const specimens = Array.from({ length: count }, (_, index) => ({
		name: `Vine ${index}`,
		link: `?v=2&preset=lychee&seed=${index + 1}`,
		saved: new Date(Date.UTC(2026, 0, 1) + index * 60_000).toISOString(),
		app: "1.0.0",
	}));
	return JSON.stringify({ format: "panicle-library", version: 1, specimens });
}
