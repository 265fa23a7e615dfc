import { drag, EditorPage } from "./editor_page";
import { expect, test } from "./fixtures";

test.use({ viewport: { width: 1440, height: 1000 } });

const PAPER = "?v=1&preset=grape-15b";

test("the bunch's own text opens beside it, and what is typed grows: a step to undo, in the link", async ({ page }) => {
	const studio = await new EditorPage(page).edit(PAPER);
	const first = await studio.fingerprint.innerText();
	await expect(studio.text).toContainText("L-system 3");
	await expect(page.getByText("Built-in grammar. Editing makes a copy.")).toBeVisible();
	await studio.endOf("#define r_p 1.5");
	await studio.line("#define r_p 1.5").locator(".cm-number").click();
	await page.keyboard.press("Alt+ArrowUp");
	await expect(studio.line("#define r_p 1.6")).toBeVisible();
	await expect(studio.fingerprint).not.toHaveText(first);
	await expect(page).toHaveURL(/#/);
	await expect(page.getByText("Edited grammar", { exact: true })).toBeVisible();
	await page.keyboard.press("Control+z");
	await expect(studio.line("#define r_p 1.5")).toBeVisible();
	await expect(studio.fingerprint).toHaveText(first);
	await expect(page.getByText("Built-in grammar. Editing makes a copy.")).toBeVisible();
	await page.keyboard.press("Control+Shift+Z");
	await expect(studio.line("#define r_p 1.6")).toBeVisible();
	await studio.button("Discard my edits").first().click();
	await expect(studio.fingerprint).toHaveText(first);
});

test("a mistake is shown where it stands, and the last bunch stays until it is mended", async ({ page }) => {
	const studio = await new EditorPage(page).edit(PAPER);
	const first = await studio.fingerprint.innerText();
	await studio.endOf("#define r_p 1.5");
	await page.keyboard.press("Home");
	await page.keyboard.press("ControlOrMeta+ArrowRight");
	await studio.endOf("axiom:");
	await page.keyboard.type(" [");
	await page.keyboard.press("Delete"); // The bracket that is closed by itself.
	await expect(studio.details.getByRole("button", { name: /^Line \d+ / })).toHaveCount(1);
	await expect(studio.text.locator(".cm-error")).toHaveCount(1);
	await expect(studio.text).toHaveAttribute("aria-invalid", "true");
	await expect(studio.canvas).toHaveAccessibleName(/\d+ berries/);
	await expect(studio.notices).not.toContainText("can’t be grown");
	await page.getByRole("checkbox", { name: "Tab indents" }).focus();
	await studio.details.getByRole("button").click();
	await expect(studio.text).toBeFocused();
	await studio.endOf("axiom:");
	for (let at = 0; at < 2; at++) await page.keyboard.press("Backspace");
	await expect(studio.details.getByRole("button")).toHaveCount(0);
	await expect(studio.text.locator(".cm-error")).toHaveCount(0);
	await expect(studio.fingerprint).toHaveText(first);
});

test("typing over a selection of coloured words replaces it, without an error of the page's policy", async ({
	page,
}) => {
	const studio = await new EditorPage(page).edit(PAPER);
	await studio.endOf("#define r_p 1.5");
	await page.keyboard.press("Shift+Home");
	await page.keyboard.type("#");
	await page.keyboard.type("define r_p 1.7");
	await expect(studio.line("#define r_p 1.7")).toBeVisible();
	await expect(studio.line("#define r_p 1.7").locator("[style]")).toHaveCount(0);
	// A selection is put between brackets, as where the browser types.
	await page.keyboard.press("Shift+Control+ArrowLeft");
	await page.keyboard.type("(");
	await expect(studio.text).toContainText(/\(1?\.?7\)/);
});

test("closing the editor over a mistake shows a message that leads back to it", { tag: "@long" }, async ({ page }) => {
	const studio = await new EditorPage(page).edit(PAPER);
	await studio.endOf("axiom:");
	await page.keyboard.type(" )");
	await expect(studio.details.getByRole("button")).toHaveCount(1);
	await studio.button("Close the grammar").click();
	await expect(studio.text).toHaveCount(0);
	await expect(studio.notices).toContainText(/Line \d+, column \d+/);
	await studio.button("Edit the grammar").last().click();
	await expect(studio.text).toBeVisible();
});

test("a remark of the core stands in its line", { tag: "@long" }, async ({ page }) => {
	const studio = await new EditorPage(page).edit(PAPER);
	await studio.endOf("Ap(l,w) -->");
	await page.keyboard.type(" F1");
	await expect(studio.details.getByRole("button", { name: /“F1” is read as a single symbol/ })).toBeVisible();
	await expect(studio.text.locator(".cm-remark")).toHaveText("F1");
});

test("a number follows the mouse in steps of its last digit, ten with Shift, tenths with Control; a drag is one step", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new EditorPage(page).edit(PAPER);
	const first = await studio.fingerprint.innerText();
	await drag(page, studio.number("#define alpha_y"), 20);
	await expect(studio.number("#define alpha_y")).toHaveText("65");
	await expect(studio.fingerprint).not.toHaveText(first);
	await drag(page, studio.number("#define alpha_y"), -20, "Shift");
	await expect(studio.number("#define alpha_y")).toHaveText("15");
	await drag(page, studio.number("#define alpha_y"), 20, "Control");
	await expect(studio.number("#define alpha_y")).toHaveText("15.5");
	for (const before of ["15", "65", "60"]) {
		await studio.button("Undo").click();
		await expect(studio.number("#define alpha_y")).toHaveText(before);
	}
	await expect(studio.fingerprint).toHaveText(first);
	await expect(studio.button("Undo")).toBeDisabled();
});

test("constants of a text of one's own are sliders that write into it", { tag: "@long" }, async ({ page }) => {
	const studio = await new EditorPage(page).edit(PAPER);
	await expect(page.locator("details[data-group=constants]")).toHaveCount(0);
	await studio.endOf("#define l_i 50");
	await page.keyboard.press("Enter");
	await page.keyboard.type("#define bend 12 /* 0 … 90 step 3, of everything */");
	await studio.openAdvanced();
	const slider = studio.slider("bend");
	await expect(slider).toHaveValue("12");
	await expect(slider).toHaveAttribute("max", "90");
	await expect(slider).toHaveAccessibleDescription(/^of everything\. 0 … 90\. Line \d+/);
	await expect(studio.slider("r_w")).toHaveCount(0); // It is a parameter's.
	await slider.focus();
	await page.keyboard.press("ArrowRight");
	await expect(studio.line("#define bend 15 /*")).toBeVisible();
	await page.keyboard.press("Shift+ArrowRight");
	await expect(studio.line("#define bend 45 /*")).toBeVisible();
	await page.keyboard.press("Control+z");
	await expect(studio.line("#define bend 12 /*")).toBeVisible();
});

test("words are completed and explained", { tag: "@long" }, async ({ page }) => {
	const studio = await new EditorPage(page).edit(PAPER);
	await studio.endOf("Ap(l,w) -->");
	await page.keyboard.type(" F(cl");
	await page.getByRole("option", { name: /^clamp/ }).click();
	await expect(studio.line("Ap(l,w) -->")).toContainText("F(clamp");
	await expect(page.locator(".pane-hint")).toContainText("limited to the range from low to high");
	await studio.see("#define r_p");
	await studio.line("#define r_p").locator(".cm-statement").hover();
	await expect(page.locator(".cm-help")).toContainText("Defines a constant.");
});

test("Tab goes on and Escape leaves, unless Tab is set to indent", { tag: "@long" }, async ({ page }) => {
	const studio = await new EditorPage(page).edit(PAPER);
	await expect(studio.text).toBeFocused();
	await expect(studio.text).toHaveAccessibleDescription(/Escape leaves/);
	await page.keyboard.press("Tab");
	await expect(page.getByRole("checkbox", { name: "Tab indents" })).toBeFocused();
	await page.keyboard.press("Space");
	await page.keyboard.press("Shift+Tab");
	await expect(studio.text).toBeFocused();
	await page.keyboard.press("Tab");
	await expect(studio.text).toBeFocused();
	await page.keyboard.press("Escape");
	await expect(studio.button("Close the grammar")).toBeFocused();
	await page.keyboard.press("Enter");
	await expect(studio.text).toHaveCount(0);
	await expect(studio.button("Grammar")).toBeFocused();
});

test("curves are drawn, and their points are moved, added and removed", { tag: "@long" }, async ({ page }) => {
	const studio = await new EditorPage(page).edit(PAPER);
	await studio.endOf("#define l_i 50");
	await page.keyboard.press("Enter");
	await page.keyboard.type("#curve taper (0, 0) (1, 1)");
	await studio.openAdvanced();
	const curve = page.getByRole("group", { name: "Curve taper" });
	await curve.getByRole("button", { name: "Add a point" }).click();
	await expect(studio.line("#curve taper")).toHaveText("#curve taper (0, 0) (0.5, 0.5) (1, 1)");
	await curve.getByRole("slider", { name: "Point 2 of 3" }).focus();
	await page.keyboard.press("Shift+ArrowUp");
	await expect(studio.line("#curve taper")).toHaveText("#curve taper (0, 0) (0.5, 0.6) (1, 1)");
	await page.keyboard.press("Delete");
	await expect(studio.line("#curve taper")).toHaveText("#curve taper (0, 0) (1, 1)");
});

test("a grammar's preset opens its text, with sliders of its constants, and grows what is typed", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new EditorPage(page).edit("?model=grammar");
	const first = await studio.fingerprint.innerText();
	await expect(page.locator("details[data-group=constants]")).toHaveCount(1);
	await studio.endOf("axiom:");
	await page.keyboard.type(" F");
	await expect(studio.fingerprint).not.toHaveText(first);
	await page.keyboard.press("Control+z");
	await expect(studio.fingerprint).toHaveText(first);
});
