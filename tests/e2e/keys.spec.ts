import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("letters in a list are the list's, and with a modifier they are nobody's", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	await page.getByRole("combobox", { name: "Family" }).first().focus();
	for (const key of ["s", "n", "o", "k"]) await page.keyboard.press(key);
	await page.keyboard.press("Escape");
	await studio.slider("Length").focus();
	for (const key of ["Alt+s", "Shift+S", "Control+o"]) await page.keyboard.press(key);
	for (const name of ["Hide berries", "Outline in 3D", "Remove berries"]) {
		await expect(studio.button(name)).toHaveAttribute("aria-pressed", "false");
	}
	await expect(studio.button("Undo")).toBeDisabled();
	await page.keyboard.press("s");
	await expect(studio.button("Hide berries")).toHaveAttribute("aria-pressed", "true");
});

test("single letters can be switched off, in every tab and for good, and the list of shortcuts says so", {
	tag: "@long",
}, async ({ page, context, complaints }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=duku");
	const other = await context.newPage();
	complaints.listenTo(other);
	const beside = await new StudioPage(other).open("?v=2&preset=duku");
	const shortcutsOf = (on: Page) => on.getByRole("dialog", { name: "Keyboard shortcuts" });
	await page.keyboard.press("?");
	const list = shortcutsOf(page);
	await expect(list.getByRole("region", { name: "General" })).toContainText("New variation");
	await expect(list.getByRole("region", { name: "View" })).toContainText("Rotate the 3D view");
	await expect(list.getByRole("region", { name: "This plant’s tools" })).toContainText("Remove berries");
	await list.getByRole("switch", { name: "Use single-letter shortcuts" }).uncheck();
	await expect(list).not.toContainText("New variation");
	await expect(list).not.toContainText("Remove berries");
	await expect(list).toContainText("Ctrl+Z");
	await page.keyboard.press("Escape");
	for (const key of ["s", "n", "?"]) await page.keyboard.press(key);
	await expect(list).toBeHidden();
	// The browser forwards the message to the other tab; that tab's own list, opened from the help, shows when it arrived.
	await other.keyboard.press("F1");
	await other.getByRole("dialog").getByRole("button", { name: "Keyboard shortcuts" }).click();
	await expect(shortcutsOf(other)).not.toContainText("New variation");
	await other.keyboard.press("Escape");
	await expect(shortcutsOf(other)).toBeHidden();
	await other.keyboard.press("n");
	for (const { button } of [studio, beside].map((each) => ({ button: each.button("Undo") }))) {
		await expect(button).toBeDisabled();
	}
	await expect(studio.button("Hide berries")).toHaveAttribute("aria-pressed", "false");
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
	await page.locator("details[data-group=basics] > summary").click();
	await other.locator("details[data-group=numbers] > summary").click();
	await expect(other.locator("details[data-group=basics]")).toHaveAttribute("open");
	await other.getByRole("button", { name: "Dark theme" }).click();
	await expect(page.getByRole("button", { name: "Light theme" })).toBeVisible();
	await page.reload();
	await expect(page.getByRole("button", { name: "Light theme" })).toBeVisible();
	for (const group of ["basics", "numbers"]) {
		await expect(page.locator(`details[data-group=${group}]`)).not.toHaveAttribute("open");
	}
});

test("a number is typed from its slider, by Enter or by its digits, and the keys go back to it", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const slider = studio.slider("Length");
	const field = page.getByRole("textbox", { name: "Length in millimetres", exact: true });
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
	await expect(studio.canvas).toHaveAttribute("aria-roledescription", "3D view");
	await expect(studio.canvas).toHaveAccessibleDescription(/Arrow keys rotate.*0 resets/);
	await expect(studio.button("Reset view")).toBeVisible();
	await page.getByRole("region", { name: "Side view" }).locator("[data-handle]").last().focus();
	await page.keyboard.press("Tab");
	await expect(studio.canvas).toBeFocused();
	expect(await studio.canvas.evaluate((canvas) => getComputedStyle(canvas).outlineStyle)).toBe("solid");
	await page.keyboard.press("Tab");
	await expect(studio.button("Reset view")).toBeFocused();
	await page.keyboard.press("ArrowDown");
	await expect(studio.button("Wind on/off")).toBeFocused();
	await page.keyboard.press("ArrowDown");
	await expect(studio.button("Show tool names")).toBeFocused();
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
	await studio.openAdvanced();
	await handle.focus();
	await studio.regrown(() => page.keyboard.press("ArrowRight"));
	const width = await page.getByRole("textbox", { name: "Right width in millimetres" }).inputValue();
	await expect(announced).toHaveText(new RegExp(`^${width} mm wide, [\\d.]+ mm below the top$`));
	const words = await announced.textContent();
	await page.keyboard.press("Enter");
	expect(await announced.textContent()).toBe(`${words}\u00a0`);
	await page.keyboard.press("Space");
	await expect.poll(() => announced.textContent()).toBe(words);
	await expect(handle).toBeFocused();
	await expect(handle).toHaveAccessibleDescription(/Enter announces the position/);
});

test("the language is chosen in the help; the page reloads in it with the same plant", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	const fingerprint = await studio.regrown(() => studio.button("New variation").click());
	await studio.button("Help").click();
	await page.getByRole("combobox", { name: "Language" }).selectOption({ label: "Français" });
	await expect(page.locator("html")).toHaveAttribute("lang", "fr");
	await expect(studio.fingerprint).toHaveText(fingerprint);
});
