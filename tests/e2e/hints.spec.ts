import type { Locator, Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test.use({ hints: true, viewport: { width: 1280, height: 800 } });

const tip = (page: Page) => page.getByRole("group", { name: "Tip" });
const POINT = "Drag a point to change the shape. The plant regrows at once.";
const TURN = "Drag the plant to turn it. Scroll or pinch to zoom.";
const PLAY = "Press Play to watch the plant grow.";

const stored = (page: Page) => page.evaluate(() => localStorage.getItem("panicle.hints"));

/** Names of the controls that a hint covers, those in shadow trees included. */
function coveredBy(hint: Locator): Promise<string[]> {
	return hint.evaluate((card) => {
		const own = card.getBoundingClientRect();
		const all = (root: ParentNode): Element[] =>
			[...root.querySelectorAll("*")].flatMap((each) => [each, ...(each.shadowRoot ? all(each.shadowRoot) : [])]);
		return all(document)
			.filter((each) => each.matches("button, a[href], input, select, textarea, summary, [data-handle]"))
			.filter((each) => !card.contains(each) && each.checkVisibility({ visibilityProperty: true }))
			.filter((each) => {
				const { left, top, right, bottom } = each.getBoundingClientRect();
				// Presets that are scrolled out of the strip are not seen.
				const strip = each.closest(".strip")?.getBoundingClientRect();
				if (strip && own.right <= strip.left) return false;
				return right > left && left < own.right && own.left < right && top < own.bottom && own.top < bottom;
			})
			.map((each) => each.getAttribute("aria-label") ?? each.textContent ?? each.tagName);
	});
}

test("a first visit has three hints, each until it was followed, and no later visit has any", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	await expect(tip(page)).toContainText(POINT);
	expect(await coveredBy(tip(page))).toEqual([]);
	// It is announced, and takes no focus.
	await expect(page.locator("panicle-hints [role=status]")).toHaveText(`Tip: ${POINT}`);
	expect(await page.evaluate(() => document.activeElement === document.body)).toBe(true);
	const { x, y } = await studio.grip("Front", "p3");
	await page.mouse.move(x, y);
	await page.mouse.down();
	await page.mouse.move(x + 12, y, { steps: 4 });
	await page.mouse.up();
	await expect(tip(page)).toContainText(TURN);
	expect(await stored(page)).toBe('["point"]');
	expect(await coveredBy(tip(page))).toEqual([]);
	const view = await studio.canvas.boundingBox();
	if (!view) throw new Error("no view");
	await page.mouse.move(view.x + view.width / 2, view.y + view.height / 2);
	await page.mouse.down();
	await page.mouse.move(view.x + view.width / 2 + 60, view.y + view.height / 2, { steps: 4 });
	await page.mouse.up();
	await expect(tip(page)).toContainText(PLAY);
	expect(await coveredBy(tip(page))).toEqual([]);
	await studio.button("Play").click();
	await expect(tip(page)).toBeHidden();
	await studio.button("Pause").click();
	expect(await stored(page)).toBe('["point","turn","play"]');
	await page.reload();
	await expect(studio.fingerprint).toHaveText(/\w/);
	await expect(page.locator("panicle-gallery[data-models='8']")).toBeAttached();
	await page.waitForTimeout(500);
	await expect(tip(page)).toHaveCount(0);
});

test("hints are dismissed one by one, by a button or by Escape, which moves the focus to their element", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	await expect(tip(page)).toContainText(POINT);
	// Escape is the hint's only while it has the focus.
	await page.keyboard.press("Escape");
	await expect(tip(page)).toContainText(POINT);
	await tip(page).getByRole("button", { name: "Got it" }).press("Escape");
	await expect(tip(page)).toContainText(TURN);
	expect(
		await page.evaluate(() => document.activeElement?.shadowRoot?.activeElement?.getAttribute("data-handle")),
	).toMatch(/\w/);
	await tip(page).getByRole("button", { name: "Got it" }).press("Enter");
	await expect(tip(page)).toContainText(PLAY);
	await expect(studio.canvas).toBeFocused();
	await tip(page).getByRole("button", { name: "Got it" }).click();
	await expect(tip(page)).toHaveCount(0);
	expect(await stored(page)).toBe('["point","turn","play"]');
});

test("a presentation hides the hint, which comes back after it", async ({ page }) => {
	await new StudioPage(page).open("?v=2&preset=cylindrical");
	await expect(tip(page)).toContainText(POINT);
	await page.keyboard.press("f");
	await expect(page.locator(".hint")).toHaveCount(0);
	await page.keyboard.press("Escape");
	await expect(tip(page)).toContainText(POINT);
});

test("all hints are skipped at once, and shown again from the help", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	await tip(page).getByRole("button", { name: "Skip tips" }).click();
	await expect(tip(page)).toHaveCount(0);
	await page.waitForTimeout(1000);
	await expect(tip(page)).toHaveCount(0);
	await studio.button("Help").click();
	await page.getByRole("dialog").getByRole("button", { name: "Show the tips again" }).click();
	await expect(page.getByRole("dialog")).toBeHidden();
	await expect(tip(page)).toContainText(POINT);
});

test("a plant without points and growth has the hint of its view only", async ({ page }) => {
	await new StudioPage(page).open("?v=2&model=grammar&preset=algae");
	await expect(tip(page)).toContainText(TURN);
	await tip(page).getByRole("button", { name: "Got it" }).click();
	await page.waitForTimeout(1000);
	await expect(tip(page)).toHaveCount(0);
	// The others are shown with the first plant that has them.
	expect(await stored(page)).toBe('["turn"]');
});

test("keys follow hints, too", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	await expect(tip(page)).toContainText(POINT);
	await studio.handle("Front", "p3").focus();
	await studio.regrown(() => page.keyboard.press("ArrowRight"));
	await expect(tip(page)).toContainText(TURN);
	await studio.canvas.press("ArrowLeft");
	await expect(tip(page)).toContainText(PLAY);
});

for (const [name, viewport, language] of [
	["a phone", { width: 390, height: 844 }, "en"],
	["320 px in French", { width: 320, height: 640 }, "fr"],
	["a laptop at 200 % in French", { width: 640, height: 400 }, "fr"],
] as const) {
	test.describe(`on ${name}`, () => {
		test.use({ viewport, hasTouch: true });

		test("hints are in the window and cover no control", async ({ page }) => {
			await page.addInitScript(
				(tag) => localStorage.setItem("panicle.ui", JSON.stringify({ language: tag })),
				language,
			);
			await page.emulateMedia({ reducedMotion: "reduce" });
			const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
			const card = page.getByRole("group", { name: language === "fr" ? "Astuce" : "Tip" });
			const done = card.getByRole("button", { name: language === "fr" ? "Compris" : "Got it" });
			const texts: string[] = [];
			for (let i = 0; i < 3; i++) {
				await expect(card).toBeVisible();
				await expect(card).toBeInViewport({ ratio: 1 });
				expect(await coveredBy(card)).toEqual([]);
				expect(await card.evaluate((each) => getComputedStyle(each).animationName)).toBe("none");
				expect(await card.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)).toBeLessThanOrEqual(0);
				texts.push(await card.locator("p").innerText());
				await done.tap();
				await expect(card).toHaveCount(0);
			}
			expect(new Set(texts).size).toBe(3);
			expect(await studio.overflow()).toBeLessThanOrEqual(0);
		});
	});
}

test("the hint on turning keeps clear of the scale bar, which is loaded later", async ({ page }) => {
	await page.setViewportSize({ width: 1600, height: 1000 });
	await page.addInitScript(() => localStorage.setItem("panicle.hints", '["point"]'));
	await new StudioPage(page).open("?v=2&model=growth&preset=figure-5");
	await expect(tip(page)).toContainText(TURN);
	await expect(page.locator(".scale-bar")).toBeVisible();
	const clear = async () => {
		const [hint, bar] = await Promise.all([tip(page), page.locator(".scale-bar")].map((each) => each.boundingBox()));
		return hint && bar && (hint.y + hint.height <= bar.y || hint.x >= bar.x + bar.width);
	};
	await expect.poll(clear).toBe(true);
});

test.describe("on a phone", () => {
	test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

	test("the hint on turning names fingers, not the wheel of a mouse", async ({ page }) => {
		await new StudioPage(page).open("?v=2&model=flower&preset=tulip");
		await expect(tip(page)).toContainText("Drag the plant to turn it. Move two fingers apart to zoom in.");
	});
});
