import { drag, EditorPage } from "./editor_page";
import { expect, test } from "./fixtures";

test.use({ viewport: { width: 1440, height: 1000 } });

const PAPER = "?v=1&preset=grape-15b";

test("words are found, one after the other, and replaced as one step; Escape goes back to the text", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new EditorPage(page).edit("?model=grammar");
	const first = await studio.fingerprint.innerText();
	await page.keyboard.press("Control+f");
	const search = page.getByRole("search", { name: "Find in the grammar" });
	await expect(search.getByRole("textbox", { name: "Find" })).toBeFocused();
	await page.keyboard.type("axiom");
	await page.keyboard.press("Enter");
	await expect(studio.text.locator(".cm-searchMatch-selected")).toHaveText("axiom");
	await page.keyboard.press("Escape");
	await expect(search).toHaveCount(0);
	await expect(studio.text).toBeFocused();

	await studio.button("Find").click();
	await search.getByRole("textbox", { name: "Find" }).fill("derivation length: ");
	await search.getByRole("textbox", { name: "Find" }).press("Enter");
	await search.getByRole("textbox", { name: "Replace" }).fill("derivation length: 2 /* was */ + ");
	await studio.regrown(() => search.getByRole("button", { name: "Replace all" }).click());
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(first);
	await expect(studio.button("Undo")).toBeDisabled();
	await search.getByRole("button", { name: "Close the search" }).click();
	await expect(search).toHaveCount(0);
});

test.describe("on a phone", () => {
	test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

	test("the text is a sheet below the plant, in letters that are not enlarged, and numbers have a handle", async ({
		page,
	}) => {
		const studio = await new EditorPage(page).edit(PAPER);
		expect(await studio.overflow()).toBeLessThanOrEqual(0);
		const [plant, text] = [await studio.canvas.boundingBox(), await studio.text.boundingBox()];
		expect(plant?.height).toBeGreaterThan(140);
		expect(text?.y).toBeGreaterThanOrEqual((plant?.y ?? 0) + (plant?.height ?? 0) - 1);
		expect(
			await studio.text.evaluate((element) => Number.parseFloat(getComputedStyle(element).fontSize)),
		).toBeGreaterThanOrEqual(16);
		await studio.see("#define alpha_y");
		await studio.number("#define alpha_y").tap();
		await expect(studio.pad).toHaveAttribute("aria-valuetext", "60");
		await page.getByRole("button", { name: "More" }).tap();
		await expect(studio.number("#define alpha_y")).toHaveText("61");
		await drag(page, studio.pad, 20);
		await expect(studio.number("#define alpha_y")).toHaveText("66");
	});

	test("the keyboard covers no line that is typed in", { tag: "@long" }, async ({ page }) => {
		await page.addInitScript(() => {
			const viewport = Object.assign(new EventTarget(), { height: 844, offsetTop: 0, scale: 1 });
			Object.defineProperty(window, "visualViewport", { value: viewport });
		});
		const studio = await new EditorPage(page).edit("?model=grammar&preset=topiary-one-cube&define=leaf:0.3");
		const covered = (height: number) =>
			page.evaluate((seen) => {
				Object.assign(window.visualViewport as object, { height: seen });
				window.visualViewport?.dispatchEvent(new Event("resize"));
			}, height);
		const scroller = page.locator(".cm-scroller");
		const before = await scroller.boundingBox();
		await studio.text.press("Control+End");
		await covered(500);
		const cursor = page.locator(".cm-cursor-primary");
		await expect(cursor).toBeInViewport();
		await expect
			.poll(async () => {
				const box = await cursor.boundingBox();
				return (box?.y ?? 0) + (box?.height ?? 0);
			})
			.toBeLessThan(500);
		expect((await scroller.boundingBox())?.height).toBeGreaterThan(150);
		await expect(page.getByRole("application")).toBeInViewport({ ratio: 0.99 });
		await covered(844);
		await expect.poll(() => scroller.boundingBox()).toEqual(before);
	});
});
