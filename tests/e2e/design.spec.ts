import type { Page } from "@playwright/test";
import { drawnBlade } from "./drawn_picture";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/**
 * Performs an action that changes the specimen and returns its link. A fingerprint covers only positions of organs,
 * the link everything.
 */
async function written(page: Page, action: () => Promise<unknown>): Promise<string> {
	const before = page.url();
	await action();
	await expect(page).not.toHaveURL(before);
	return page.url();
}

test("a flower is designed: choices, the diagram and the outline write its text, and undo, redo and the link bring it back", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=designed-buttercup");
	await studio.openAdvanced();
	const before = page.url();
	await expect(page.getByText("K5 C5 A12+12+12 G14")).toBeVisible();
	await expect(page.getByRole("slider", { name: /^Steps/ })).toHaveAttribute("aria-valuetext", "auto");
	const download = page.waitForEvent("download");
	await studio.button("Diagram as SVG").click();
	expect((await download).suggestedFilename()).toBe("designed-buttercup-diagram.svg");
	// A choice: each petal is lanceolate, and the readout of the fit shows it.
	const chosen = await written(page, () => page.getByRole("combobox", { name: "Outline" }).selectOption("Lanceolate"));
	await expect(page.getByText(/within 1\.\d % of its width/)).toBeVisible();

	// The diagram: the handle of how many is drawn from a fifth to a third of the way round, in one step.
	const count = page.getByRole("button", { name: /^Petals per whorl/ });
	await expect(count).toHaveAccessibleName(/: 5$/);
	const grip = await studio.grip("Diagram", "petal-count");
	const radius = await studio.grip("Diagram", "petal-radius");
	const turned = (2 * Math.PI) / 5;
	const ring = (radius.x - grip.x) / Math.sin(turned);
	const middle = { x: radius.x, y: grip.y - ring * Math.cos(turned) };
	const third = (2 * Math.PI) / 3;
	await page.mouse.move(grip.x, grip.y);
	await page.mouse.down();
	const grown = await studio.fingerprint.textContent();
	const counted = await written(page, async () => {
		await page.mouse.move(middle.x - ring, middle.y, { steps: 4 });
		await page.mouse.move(middle.x - ring * Math.sin(third), middle.y + ring * Math.cos(third), { steps: 4 });
		await page.mouse.up();
	});
	await expect(count).toHaveAccessibleName(/: 3$/);
	await expect(page.getByText("K5 C3 A12+12+12 G14")).toBeVisible();
	await expect(studio.fingerprint).not.toHaveText(grown ?? "");

	// The outline: the keyboard moves a point, after which the shape is a custom one.
	const point = page.getByRole("button", { name: /^Point 4 of the outline/ });
	await point.focus();
	const drawn = await written(page, () => point.press("Shift+ArrowLeft"));
	await expect(page.getByRole("combobox", { name: "Outline" })).toHaveValue("drawn");
	const print = await studio.fingerprint.textContent();

	for (const there of [counted, chosen, before]) {
		await studio.button("Undo").click();
		await expect(page).toHaveURL(there);
		await expect(count).toHaveAccessibleName(there === counted ? /: 3$/ : /: 5$/);
	}
	for (const there of [chosen, counted, drawn]) {
		await studio.button("Redo").click();
		await expect(page).toHaveURL(there);
	}
	await page.goto("about:blank");
	await page.goto(drawn);
	await expect(studio.fingerprint).toHaveText(print ?? "");
	await expect(count).toHaveAccessibleName(/: 3$/);
	await expect(page.getByRole("combobox", { name: "Outline" })).toHaveValue("drawn");
	// It is still the preset, altered, though its whole text came by the link.
	await expect(page).toHaveTitle(/^Buttercup by choices \(edited\)/);
});

test("edits by hand survive a choice elsewhere; those that cannot are listed, and can be kept", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=designed-tulip");
	await studio.openAdvanced();
	await page.getByLabel("Stamen", { exact: true }).check();
	const text = page.getByRole("region", { name: "Grammar" }).locator(".cm-content");
	await studio.button("Grammar").click();
	await text.click();
	await page.keyboard.press("ControlOrMeta+End");
	// A line of its own below the pistil's section: a wider style.
	await written(page, () => page.keyboard.insertText("STYLE -> STYLE[LOBE]_{C2}\n"));
	await studio.button("Close the grammar").click();
	await page.getByLabel("Pistil", { exact: true }).check();
	await expect(page.getByText("You edited this grammar by hand")).toBeVisible();
	// By keys alone: digits on the slider go to its field, Enter brings them back.
	const length = studio.slider("Ovary");
	await length.focus();
	await written(page, async () => {
		await page.keyboard.type("30");
		await expect(page.getByRole("textbox", { name: "Ovary, typed" })).toBeFocused();
		await page.keyboard.press("Enter");
	});
	await expect(length).toBeFocused();
	await expect(length).toHaveValue("30");
	await expect(length).toHaveAttribute("aria-valuetext", "30 mm");
	await expect(page.getByText("You edited this grammar by hand")).toBeVisible();
	await expect(studio.notices).not.toContainText("replaced lines");
	await written(page, () => studio.button("Rebuild grammar").click());
	await expect(page.getByText("You edited this grammar by hand")).toHaveCount(0);
	// A line that a choice writes, too.
	await page.getByLabel("Stem", { exact: true }).check();
	await studio.button("Grammar").click();
	await text.locator(".cm-line", { hasText: "#define thick=6.4" }).click();
	await page.keyboard.press("Home");
	await page.keyboard.press("Shift+End");
	await page.keyboard.press("Delete");
	await written(page, () => page.keyboard.insertText("#define thick=9"));
	await studio.button("Close the grammar").click();
	const thickness = page.getByRole("textbox", { name: "Thickness, typed" });
	await written(page, async () => {
		await thickness.fill("4");
		await thickness.press("Enter");
	});
	await expect(studio.notices).toContainText("#define thick=9");
	const lost = page.url();
	await written(page, () => studio.button("Restore my lines").click());
	await expect(page.getByText("You edited this grammar by hand")).toBeVisible();
	await studio.button("Undo").click();
	await expect(page).toHaveURL(lost);
});

test("a picture that is dropped is traced as the chosen organ; a handle of the diagram adds a whorl of it", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=designed-buttercup");
	await studio.openAdvanced();
	const [outline, width] = [page.getByRole("combobox", { name: "Outline" }), studio.slider("Width")];
	const [before, length] = [page.url(), Number(await studio.slider("Length").inputValue())];
	await written(page, async () => studio.drop("petal.png", await drawnBlade(page)));
	await expect(studio.notices).toContainText("Traced the outline of a petal");
	await expect(outline).toHaveValue("drawn");
	// 100 of 160 wide, without its stalk.
	expect(Number(await width.inputValue()) / length).toBeCloseTo(100 / 160, 1);
	await studio.button("Undo").click();
	await expect(page).toHaveURL(before);
	await expect(outline).not.toHaveValue("drawn");
	await page.getByLabel("Sepal", { exact: true }).check();
	await written(page, async () => studio.drop("sepal.png", await drawnBlade(page)));
	await expect(studio.notices).toContainText("Traced the outline of a sepal");
	await expect(outline).toHaveValue("drawn");
	const traced = page.url();
	await studio.drop("no.png", Buffer.from("no picture"));
	await expect(studio.notices).toContainText("The file is not a picture that this browser can read");
	await expect(page).toHaveURL(traced);

	await page.getByLabel("Petal", { exact: true }).check();
	const whorls = page.getByRole("button", { name: /^Whorls of petals/ });
	await expect(whorls).toHaveAccessibleName(/: 1$/);
	await whorls.focus();
	await written(page, () => whorls.press("ArrowUp"));
	await expect(whorls).toHaveAccessibleName(/: 2$/);
	await expect(page.getByText("C5+5")).toBeVisible();
});

test("a text without descriptions says so, and a design begins", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=table-3");
	await studio.openAdvanced();
	await expect(page.getByText("does not describe its organs")).toBeVisible();
	await expect(page.getByRole("region", { name: "Diagram view" })).toHaveCount(0);
	await studio.button("Open Tulip by choices").click();
	await expect(page.getByRole("region", { name: "Diagram view" })).toBeVisible();
	await studio.button("Undo").click();
	await written(page, () => studio.button("Design a new flower").click());
	await expect(page.getByText("P5 A5 G(3)")).toBeVisible();
	const count = page.getByRole("textbox", { name: "Count, typed" });
	for (const [typed, message] of [
		["abc", "“abc” is not a number. Count is still 5."],
		["99", "99 was changed to 21."],
	]) {
		await count.fill(typed);
		await count.press("Enter");
		await expect(page.getByText(message)).toBeVisible();
	}
	await expect(page.getByRole("region", { name: "Diagram view" })).toBeVisible();
});

test("on a phone the diagram and the outline are views of their own, whose handles a finger can take", {
	tag: "@long",
}, async ({ page }) => {
	await page.setViewportSize({ width: 390, height: 844 });
	await new StudioPage(page).open("?v=2&model=flower&preset=designed-violet");
	await page.getByRole("radio", { name: "Diagram" }).check({ force: true });
	const radius = page.getByRole("button", { name: /^Radius of the petal whorl/ });
	await radius.focus();
	await written(page, () => radius.press("Shift+ArrowUp"));
	await expect(radius).toHaveAccessibleName(/2\.9 mm$/);
	for (const handle of await page.getByRole("region", { name: "Diagram view" }).getByRole("button").all()) {
		const box = await handle.boundingBox();
		expect(box?.width).toBeCloseTo(44, 3);
		expect((box?.x ?? -1) + 22).toBeGreaterThan(0);
		expect((box?.x ?? 999) + 22).toBeLessThan(390);
	}
});
