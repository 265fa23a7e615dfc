import type { Locator, Page } from "@playwright/test";
import { expect } from "./fixtures";
import { StudioPage } from "./studio_page";

/** The page with the grammar open beside the plant. */
export class EditorPage extends StudioPage {
	get text(): Locator {
		return this.page.getByRole("textbox", { name: "Grammar", exact: true });
	}

	get pad(): Locator {
		return this.page.getByRole("slider", { name: "Number at the cursor" });
	}

	get details(): Locator {
		return this.page.locator(".pane-messages");
	}

	async edit(search = ""): Promise<this> {
		await this.open(search);
		await this.button("Grammar").click();
		await expect(this.text).toBeVisible();
		return this;
	}

	line(words: string): Locator {
		return this.text.locator(".cm-line", { hasText: words }).first();
	}

	/** Scrolls to a line: those out of sight are not in the page. */
	async see(words: string): Promise<void> {
		const scroller = this.page.locator(".cm-scroller");
		await scroller.evaluate((element) => element.scrollTo(0, 0));
		await expect(async () => {
			if ((await this.line(words).count()) === 0) await scroller.evaluate((element) => element.scrollBy(0, 200));
			await this.line(words).scrollIntoViewIfNeeded({ timeout: 200 });
		}).toPass({ intervals: [50] });
	}

	/** Puts the cursor at the end of a line. */
	async endOf(words: string): Promise<void> {
		await this.see(words);
		await this.line(words).click({ position: { x: 60, y: 6 } });
		await this.page.keyboard.press("End");
	}

	/** A number of a line, as it is written. */
	number(words: string): Locator {
		return this.line(words).locator(".cm-number").first();
	}
}

/** Drags across something by so many pixels. */
export async function drag(page: Page, what: Locator, pixels: number, key?: string): Promise<void> {
	await what.scrollIntoViewIfNeeded();
	const box = await what.boundingBox();
	if (!box) throw new Error("Nothing to drag.");
	const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
	await page.mouse.move(x, y);
	await page.mouse.down();
	if (key) await page.keyboard.down(key);
	await page.mouse.move(x + pixels / 2, y, { steps: 4 });
	await page.mouse.move(x + pixels, y, { steps: 4 });
	await page.mouse.up();
	if (key) await page.keyboard.up(key);
}
