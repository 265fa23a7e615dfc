import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("letters in a list are the list's, and with a modifier they are nobody's", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	await page.getByRole("combobox", { name: "Kind of preset" }).focus();
	for (const key of ["s", "n", "o", "t", "k"]) await page.keyboard.press(key);
	await page.keyboard.press("Escape");
	await studio.slider("Length").focus();
	for (const key of ["Alt+s", "Shift+S", "Control+o"]) await page.keyboard.press(key);
	for (const name of ["Show stems only", "Octahedron", "Thin"]) {
		await expect(studio.button(name)).toHaveAttribute("aria-pressed", "false");
	}
	await expect(studio.button("Undo")).toBeDisabled();
	await page.keyboard.press("s");
	await expect(studio.button("Show stems only")).toHaveAttribute("aria-pressed", "true");
});

test("single letters can be switched off, in every tab and for good, and the help says so", { tag: "@long" }, async ({
	page,
	context,
	complaints,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=duku");
	const other = await context.newPage();
	complaints.listenTo(other);
	const beside = await new StudioPage(other).open("?v=2&preset=duku");
	await studio.button("Help").click();
	const help = page.getByRole("dialog", { name: "Panicle" });
	await expect(help).toContainText("New variation");
	// It is read from its beginning.
	await expect(help.getByRole("heading", { name: "Panicle" })).toBeFocused();
	expect(await help.evaluate(({ scrollTop }) => scrollTop)).toBe(0);
	await help.getByRole("switch", { name: "Single letters are keys" }).uncheck();
	await expect(help).not.toContainText("New variation");
	await expect(help).toContainText("Ctrl+Z");
	await page.keyboard.press("Escape");
	for (const key of ["s", "n", "?"]) await page.keyboard.press(key);
	await expect(help).toBeHidden();
	// The browser forwards the message to the other tab; that tab's own help shows when it arrived.
	await beside.button("Help").click();
	await expect(other.getByRole("dialog", { name: "Panicle" })).not.toContainText("New variation");
	await other.keyboard.press("Escape");
	await other.keyboard.press("n");
	for (const { button } of [studio, beside].map((each) => ({ button: each.button("Undo") }))) {
		await expect(button).toBeDisabled();
	}
	await expect(studio.button("Show stems only")).toHaveAttribute("aria-pressed", "false");
	await page.reload();
	await expect(studio.canvas).toHaveAccessibleName(/berries/);
	await page.keyboard.press("n");
	await expect(studio.button("Undo")).toBeDisabled();
});

test("two tabs keep each other's settings, and have the theme in common", { tag: "@long" }, async ({
	page,
	context,
	complaints,
}) => {
	await new StudioPage(page).open("?v=2&preset=duku");
	const other = await context.newPage();
	complaints.listenTo(other);
	await new StudioPage(other).open("?v=2&preset=duku");
	await page.locator("details[data-group=shape] > summary").click();
	await other.locator("details[data-group=numbers] > summary").click();
	await expect(other.locator("details[data-group=shape]")).toHaveAttribute("open");
	await other.getByRole("button", { name: "Dark theme" }).click();
	await expect(page.getByRole("button", { name: "Light theme" })).toBeVisible();
	await page.reload();
	await expect(page.getByRole("button", { name: "Light theme" })).toBeVisible();
	for (const group of ["shape", "numbers"]) {
		await expect(page.locator(`details[data-group=${group}]`)).not.toHaveAttribute("open");
	}
});

test("a number is typed from its slider, by Enter or by its digits, and the keys go back to it", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const slider = studio.slider("Length");
	const field = page.getByRole("textbox", { name: "Length in millimetres" });
	await slider.focus();
	await page.keyboard.press("Enter");
	await expect(field).toBeFocused();
	await page.keyboard.type("150");
	await page.keyboard.press("Enter");
	await expect(slider).toBeFocused();
	await expect(slider).toHaveValue("348");
	await page.keyboard.type("41");
	await expect(field).toHaveValue("41");
	await page.keyboard.press("Escape");
	await expect(slider).toBeFocused();
	await expect(slider).toHaveValue("348");
	await expect(field).toHaveValue("150");
	// Half-typed text stays when the page updates meanwhile, as when a bunch arrives.
	await studio.slider("Age").focus();
	await page.keyboard.type("3");
	await page.emulateMedia({ colorScheme: "dark" });
	await expect(page.getByRole("button", { name: "Light theme" })).toBeVisible();
	await page.keyboard.type("0");
	await page.keyboard.press("Enter");
	await expect(studio.slider("Age")).toBeFocused();
	await expect(studio.slider("Age")).toHaveValue("30");
});

test("the view says that it takes keys, shows the focus, and its tools are one stop", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
	await expect(studio.canvas).toHaveAttribute("aria-roledescription", "3-D view");
	await expect(studio.canvas).toHaveAccessibleDescription(/Arrow keys orbit.*plus and minus.*0 resets/);
	await expect(studio.button("Reset view")).toBeVisible();
	await page.getByRole("region", { name: "Side view" }).locator("[data-handle]").last().focus();
	await page.keyboard.press("Tab");
	await expect(studio.canvas).toBeFocused();
	expect(await studio.canvas.evaluate((canvas) => getComputedStyle(canvas).outlineStyle)).toBe("solid");
	await page.keyboard.press("Tab");
	await expect(studio.button("Reset view")).toBeFocused();
	await page.keyboard.press("ArrowDown");
	await expect(studio.button("Wind")).toBeFocused();
	await page.keyboard.press("ArrowDown");
	await expect(studio.button("On the vine")).toBeFocused();
	await page.keyboard.press("End");
	await expect(studio.button("Grammar")).toBeFocused();
	await page.keyboard.press("Tab");
	await expect(studio.button("Play")).toBeFocused();
	await page.keyboard.press("Shift+Tab");
	await expect(studio.button("Grammar")).toBeFocused();
});

test("a handle says where it stands: after a key step, and when it is pressed, every time", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const view = page.getByRole("region", { name: "Front view" });
	const announced = view.locator("[aria-live=polite]");
	const handle = studio.handle("Front", "p3");
	await expect(announced).toHaveText("");
	await handle.focus();
	await studio.regrown(() => page.keyboard.press("ArrowRight"));
	const width = await page.getByRole("textbox", { name: "Right width in millimetres" }).inputValue();
	await expect(announced).toHaveText(new RegExp(`^${width} mm wide, [\\d.]+ mm down$`));
	const words = await announced.textContent();
	await page.keyboard.press("Enter");
	expect(await announced.textContent()).toBe(`${words}\u00a0`);
	await page.keyboard.press("Space");
	await expect.poll(() => announced.textContent()).toBe(words);
	await expect(handle).toBeFocused();
	await expect(handle).toHaveAccessibleDescription(/Enter says where it stands/);
});
