/** The panel: the basics of a plant, and everything else under "Advanced". */
import type { Locator } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("the height of an oak is typed in metres among the basics, and undone", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=growth&preset=oak&steps=6");
	const height = page.getByRole("textbox", { name: "Space height in metres", exact: true });
	await expect(height).toHaveValue("16");
	const measured = studio.measure("height");
	const tall = await measured.innerText();
	await height.fill("8.5");
	await studio.regrown(() => height.press("Enter"));
	await expect(height).toHaveValue("8.5");
	await expect(studio.slider("Space height")).toHaveAttribute("aria-valuetext", "8.5 metres");
	await expect(studio.slider("Space width")).toHaveValue("20");
	await expect(measured).not.toHaveText(tall);
	await height.fill("500");
	await height.press("Enter");
	await expect(page.getByText("Space height: 500 was changed to 100.")).toBeVisible();
	for (const before of ["8.5", "16"]) {
		await studio.regrown(() => studio.button("Undo").click());
		await expect(height).toHaveValue(before);
	}
	await expect(studio.button("Undo")).toBeDisabled();
	await test.step("the command palette finds it", async () => {
		await page.keyboard.press("Control+k");
		await page.getByRole("combobox", { name: "Search plants, settings, actions and help" }).fill("height");
		await page
			.getByRole("option", { name: /^Space height/ })
			.first()
			.click();
		await expect(studio.slider("Space height")).toBeFocused();
	});
});

test("the constants of a flower’s grammar are labelled basics with units, and its notes on lines are not in Numbers", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=tulip");
	await expect(studio.slider("Stem bend")).toHaveAttribute("aria-valuetext", "0 degrees");
	const length = page.getByRole("textbox", { name: "Length in millimetres", exact: true });
	await expect(length).toHaveValue("325");
	await expect(page.getByRole("textbox", { name: "Flower size", exact: false })).toHaveValue("1");
	await studio.regrown(() => length.fill("250").then(() => length.press("Enter")));
	await expect(page).toHaveURL(/define=length:250/);
	await expect(page.locator("panicle-readout .notes")).toHaveCount(0);
});

test("groups other than the basics are under Advanced, which opens on request and stays open", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const advanced = page.locator("details[data-group=advanced]");
	await expect(page.locator(".panel-groups > .group > summary")).toHaveText(["Basics", "Numbers", "Advanced"]);
	await expect(advanced).not.toHaveAttribute("open");
	await expect(studio.slider("Berry count")).toBeVisible();
	await expect(studio.slider("Right width")).toHaveCount(0);
	await advanced.locator("> summary").click();
	await expect(studio.slider("Right width")).toBeVisible();
	await expect(studio.slider("Berry count")).toHaveCount(1);
	await page.reload();
	await expect(studio.slider("Right width")).toBeVisible();
	await expect(page.locator("details[data-group=branching]")).not.toHaveAttribute("open");
});

test("a click on a part of the plant opens the group under Advanced that describes the part", { tag: "@long" }, async ({
	page,
}) => {
	await new StudioPage(page).open("?v=2&model=flower&preset=petal");
	const advanced = page.locator("details[data-group=advanced]");
	await expect(advanced).not.toHaveAttribute("open");
	const box = await page.getByRole("application", { name: /^Flower/ }).boundingBox();
	if (!box) throw new Error("no view");
	await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.45 * box.height);
	await expect(page.locator(".volume-name")).toHaveText(/^Petal/);
	await expect(page.locator(".volume-name")).toBeInViewport();
});

test("the number of steps of an L-system is set among the basics", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=grammar&preset=monopodial-tree");
	await expect(studio.slider("Steps")).toHaveValue("10");
	await studio.regrown(() => studio.slider("Steps").press("ArrowLeft"));
	await expect(page).toHaveURL(/[?&]steps=9/);
	await expect(studio.slider("r1")).toBeVisible();
	await studio.regrown(() => studio.slider("Steps").press("Delete"));
	await expect(page).not.toHaveURL(/steps=/);
});

test("petals of a designed flower are counted and coloured among the basics", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=designed-buttercup");
	await expect(studio.slider("Petals")).toHaveValue("5");
	await studio.regrown(() => studio.slider("Petals").press("ArrowRight"));
	await expect(page.getByText("K5 C6 A12+12+12 G14")).toBeAttached();
	await page.getByLabel("Petal colour", { exact: true }).fill("#ff8800");
	await expect(page).toHaveURL(/#g=/);
});

test("an info button explains a control beneath it, one at a time, by pointer and by key", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const about = (name: string) => studio.button(`About ${name}`);
	const explanation = page.getByRole("note");
	await expect(explanation).toHaveCount(0);
	await about("Berry width").click();
	await expect(about("Berry width")).toHaveAttribute("aria-expanded", "true");
	await expect(explanation).toHaveText(
		/^.+\. 3 … 60 mm\. Double-click the name or press Delete to reset to [\d.]+ mm\.$/,
	);
	await test.step("beneath the row", async () => {
		const [slider, note] = [await studio.slider("Berry width").boundingBox(), await explanation.boundingBox()];
		expect(note?.y).toBeGreaterThan(slider?.y ?? Number.POSITIVE_INFINITY);
	});
	await studio.slider("Density").focus();
	await page.keyboard.press("Tab");
	await expect(about("Density")).toBeFocused();
	await page.keyboard.press("Enter");
	await expect(explanation).toHaveCount(1);
	await expect(about("Berry width")).toHaveAttribute("aria-expanded", "false");
	await page.keyboard.press("Escape");
	await expect(explanation).toHaveCount(0);
	await expect(about("Density")).toBeFocused();
	await about("Skin colour").click();
	await expect(explanation).toContainText("reset to #");
	await about("Skin colour").click();
	await expect(explanation).toHaveCount(0);
});

test.describe("by touch", () => {
	test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

	test("a tap on an info button explains a control, and a second tap hides the explanation", async ({ page }) => {
		const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
		const about = studio.button("About Length");
		await about.tap();
		await expect(page.getByRole("note")).toBeVisible();
		await about.tap();
		await expect(page.getByRole("note")).toHaveCount(0);
	});
});

test("symbols of the papers are shown on request, and stay so", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const length = page.locator("[data-key=l] .symbol");
	await expect(length).toBeHidden();
	await studio.openAdvanced();
	await page.getByRole("switch", { name: "Show symbols" }).check();
	await expect(length).toBeVisible();
	await expect(length).toHaveText("l");
	await page.reload();
	await expect(length).toBeVisible();
	await page.getByRole("switch", { name: "Show symbols" }).uncheck();
	await expect(length).toBeHidden();
});

test("a value looks like a field: it has a border that can be seen, its unit inside, and the pointer of a text", async ({
	page,
}) => {
	await new StudioPage(page).open("?v=2&preset=cylindrical");
	const field = page.locator("[data-key=l] .field");
	for (const colorScheme of ["light", "dark"] as const) {
		await page.emulateMedia({ colorScheme });
		await expect.poll(() => borderContrast(field)).toBeGreaterThanOrEqual(3);
	}
	await expect(field).toHaveText("mm");
	await expect(page.getByRole("textbox", { name: "Length in millimetres" })).toHaveCSS("cursor", "text");
});

test("no value is cut off by its field in windows of any size", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=riesling");
	await studio.openAdvanced();
	for (const [width, height] of [
		[1440, 900],
		[1100, 700],
		[390, 844],
		[320, 640],
	]) {
		await page.setViewportSize({ width, height });
		const cut = await page
			.locator(".field .typed:visible")
			.evaluateAll((fields) =>
				(fields as HTMLInputElement[])
					.filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth)
					.map(({ ariaLabel, value }) => `${ariaLabel}: ${value}`),
			);
		expect(cut, `at ${width} × ${height}`).toEqual([]);
		expect(await page.locator(".field .typed:visible").count()).toBeGreaterThan(10);
	}
});

/** The contrast of an element's border with its background (WCAG 1.4.11). */
function borderContrast(element: Locator): Promise<number> {
	return element.evaluate((box) => {
		const style = getComputedStyle(box);
		const luminance = (colour: string) => {
			const [r, g, b] = (colour.match(/[\d.]+/g) ?? []).map((digits) => {
				const value = Number(digits) / 255;
				return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
			});
			return 0.2126 * r + 0.7152 * g + 0.0722 * b;
		};
		const [low, high] = [style.borderTopColor, style.backgroundColor].map(luminance).sort((a, b) => a - b);
		return style.borderTopWidth === "0px" ? 1 : (high + 0.05) / (low + 0.05);
	});
}
