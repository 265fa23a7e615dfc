import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const caption = /([\d.]+ (?:cm|mm)) tall, (\d+) organs?, ([\d,]+) volumes/;

test("a flower's text is edited: it regrows, a mistake is told, undo and the link bring it back", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=table-3");
	const words = page.getByText(caption).first();
	await expect(words).toContainText("4 organs");
	const grown = await studio.fingerprint.textContent();
	await studio.button("Grammar").click();
	const text = page.getByRole("region", { name: "Grammar" }).locator(".cm-content");
	await text.click();
	await page.keyboard.press("ControlOrMeta+Home");
	// The printed grammar with one more petal.
	await studio.regrown(() => page.keyboard.insertText("p0 RECEPTACLE -> RECEPTACLE[PETAL]_{C1}\n"));
	await expect(words).toContainText("5 organs");
	await expect(page).toHaveURL(/#g=/);
	const [more, link] = [await studio.fingerprint.textContent(), page.url()];
	await page.keyboard.insertText("p0 PETAL -> PETAL[SEPAL]_{E}\n");
	await expect(page.getByText("Nothing says what SEPAL is").first()).toBeVisible();
	expect(await studio.fingerprint.textContent()).toBe(more);
	await page.goto("about:blank");
	await page.goto(link);
	await expect(studio.fingerprint).toHaveText(more ?? "");
	await page.goto("?v=2&model=flower&preset=table-3");
	await expect(studio.fingerprint).toHaveText(grown ?? "");
});
