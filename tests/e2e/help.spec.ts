import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const helpOf = (page: Page) => page.getByRole("dialog", { name: "Help" });

test("the help opens at its beginning by F1, also from a field, and gives the focus back", async ({ page }) => {
	await new StudioPage(page).open("?v=2&preset=duku");
	const field = page.getByRole("textbox", { name: "Seed", exact: true });
	await field.focus();
	await page.keyboard.press("F1");
	const help = helpOf(page);
	await expect(help.getByRole("heading", { name: "First steps" })).toBeInViewport();
	await expect(help.getByRole("heading", { name: "About Panicle" })).not.toBeInViewport();
	await page.keyboard.press("Escape");
	await expect(help).toBeHidden();
	await expect(field).toBeFocused();
});

test("the contents lead to sections, which link to the documentation of this plant", async ({ page }) => {
	await new StudioPage(page).open("?v=2&model=leaf");
	await page.getByRole("button", { name: "Help" }).click();
	const help = helpOf(page);
	const address = page.url();
	for (const name of ["Growth and time", "About Panicle", "Shape"]) {
		await help.getByRole("navigation", { name: "Contents" }).getByRole("link", { name, exact: true }).click();
		await expect(help.getByRole("heading", { name, exact: true })).toBeFocused();
		await expect(help.getByRole("heading", { name, exact: true })).toBeInViewport();
	}
	// The fragment may hold a grammar: the contents do not change it.
	expect(page.url()).toBe(address);
	const shape = help.getByRole("region", { name: "Shape" });
	await expect(shape).toContainText("Drag the points of a leaf’s outline");
	await expect(shape.getByRole("link", { name: "All parameters of this model" })).toHaveAttribute(
		"href",
		"docs/models/leaf/parameters.html",
	);
});

test("its pictures are fetched only when it is opened, and are there", async ({ page }) => {
	const fetched: string[] = [];
	page.on("request", (request) => fetched.push(new URL(request.url()).pathname));
	await new StudioPage(page).open("?v=2&model=grammar");
	expect(fetched.filter((path) => /help-|\/leaf\/ivy/.test(path))).toEqual([]);
	await page.keyboard.press("F1");
	const pictures = helpOf(page).locator("img");
	await expect(pictures).toHaveCount(6);
	for (const picture of await pictures.all()) {
		await picture.scrollIntoViewIfNeeded();
		await expect.poll(() => picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(0);
	}
	await expect(helpOf(page).locator(".help-picture svg")).toHaveCount(5);
});

test("the palette opens a section of the help", async ({ page }) => {
	await new StudioPage(page).open();
	await page.keyboard.press("Control+k");
	await page.getByRole("combobox", { name: /^Search plants/ }).fill("files and sharing");
	await page.getByRole("option", { name: "Help: Files and sharing" }).click();
	await expect(helpOf(page).getByRole("heading", { name: "Files and sharing" })).toBeFocused();
	await expect(helpOf(page).getByRole("heading", { name: "Files and sharing" })).toBeInViewport();
});

for (const [width, height] of [
	[320, 640],
	[640, 400],
	[1440, 900],
] as const) {
	test(`the help fits ${width} × ${height} in French, with its contents`, async ({ page }) => {
		await page.setViewportSize({ width, height });
		await page.addInitScript(() => localStorage.setItem("panicle.ui", '{"language":"fr"}'));
		const studio = await new StudioPage(page).open();
		await page.keyboard.press("F1");
		const help = page.getByRole("dialog", { name: "Aide" });
		await help.getByRole("link", { name: "Fichiers et partage" }).click();
		await expect(help.getByRole("heading", { name: "Fichiers et partage" })).toBeInViewport();
		for (const part of [help, help.locator(".help-body")])
			expect(await part.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)).toBeLessThanOrEqual(0);
		expect(await studio.overflow()).toBeLessThanOrEqual(0);
	});
}
