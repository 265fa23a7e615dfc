import { expect, test } from "./fixtures";
import { framesRequested, passFrames } from "./frames";
import { agesUntilGrown } from "./played_ages";
import { StudioPage } from "./studio_page";

const NATURAL = "?v=2&preset=short-conical";

/** Where on the page the thumb of the age's slider is, at an age. */
async function thumb(studio: StudioPage, age: number): Promise<{ x: number; y: number }> {
	const box = await studio.slider("Age").boundingBox();
	if (!box) throw new Error("no age");
	return { x: box.x + 7 + ((box.width - 14) * age) / 125, y: box.y + box.height / 2 };
}

test("scrubbing the age and back gives the same bunch and leaves no step", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open(NATURAL);
	const first = await studio.fingerprint.innerText();
	const [ripe, green] = [await thumb(studio, 100), await thumb(studio, 40)];
	await page.mouse.move(ripe.x, ripe.y);
	await page.mouse.down();
	await studio.regrown(() => page.mouse.move(green.x, green.y, { steps: 4 }));
	await expect(studio.slider("Age")).toHaveAttribute("aria-valuetext", /^Green, /);
	await page.mouse.move(ripe.x, ripe.y, { steps: 4 });
	await page.mouse.up();
	await expect(studio.slider("Age")).toHaveValue("100");
	await expect(studio.fingerprint).toHaveText(first);
	await expect(studio.button("Undo")).toBeDisabled();
});

test("an age is one step, in the address and in the history, by stage, key and number", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open(NATURAL);
	const age = studio.slider("Age");
	const first = await studio.fingerprint.innerText();
	const set = await studio.regrown(() => studio.button("Green").click());
	await expect(age).toHaveValue("30");
	await expect(page).toHaveURL(/[?&]age=30\b/);
	await age.focus();
	await studio.regrown(() => page.keyboard.press("PageUp"));
	await expect(age).toHaveAttribute("aria-valuetext", "Colouring, 60 percent");
	await studio.regrown(() => page.keyboard.press("PageDown"));
	await expect(studio.fingerprint).toHaveText(set);
	await studio.regrown(() => page.keyboard.press("Shift+ArrowRight"));
	await expect(age).toHaveValue("35"); // Ten steps, as on every slider.
	const field = page.getByRole("textbox", { name: "Age in percent" });
	await field.fill("200");
	await field.press("Enter");
	await expect(field).toHaveValue("125");
	await expect(studio.notices).toContainText("200 was changed to 125");
	await age.focus();
	await studio.regrown(() => page.keyboard.press("Delete"));
	await expect(studio.fingerprint).toHaveText(first);
	for (const value of ["125", "35", "30", "60", "30", "100"]) {
		await studio.button("Undo").click();
		await expect(age).toHaveValue(value);
	}
	await expect(studio.button("Undo")).toBeDisabled();
});

test("play runs from the flower on, by key or button, and a pause is one step", async ({ page }) => {
	const studio = await new StudioPage(page).open(NATURAL);
	const age = studio.slider("Age");
	// The life is not played until the button is pressed.
	await passFrames(page, 10);
	await expect(studio.button("Play")).toBeVisible();
	await expect(age).toHaveValue("100");
	await studio.regrown(() => studio.button("Play").click());
	await expect(studio.button("Pause")).toBeVisible();
	await expect.poll(async () => Number(await age.inputValue())).toBeLessThan(100);
	await expect.poll(async () => Number(await age.inputValue())).toBeGreaterThan(5);
	await studio.button("Pause").click();
	await expect(studio.button("Play")).toBeVisible();
	const stopped = await age.inputValue();
	await expect(page).toHaveURL(/[?&]age=/);
	await expect.poll(() => framesRequested(page)).toBe(0);
	await expect(age).toHaveValue(stopped);
	await age.focus();
	await page.keyboard.press("k");
	await expect(studio.button("Pause")).toBeVisible();
	await expect.poll(async () => Number(await age.inputValue())).toBeGreaterThan(Number(stopped));
	await page.keyboard.press(" ");
	await expect(studio.button("Play")).toBeVisible();
	await studio.button("Undo").click();
	await expect(age).toHaveValue(stopped);
	await studio.button("Undo").click();
	await expect(age).toHaveValue("100");
	await expect(studio.button("Undo")).toBeDisabled();
});

test("where motion is unwelcome, play goes from stage to stage", { tag: "@long" }, async ({ page }) => {
	await page.emulateMedia({ reducedMotion: "reduce" });
	const studio = await new StudioPage(page).open(`${NATURAL}&age=30`);
	const seen = agesUntilGrown(page);
	await studio.button("Play").click();
	expect(await seen).toEqual(["30", "60", "100"]);
});

test("a handle can be dragged at any age", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open(`${NATURAL}&age=30`);
	const { x, y } = await studio.grip("Front", "p3");
	await page.mouse.move(x, y);
	await page.mouse.down();
	await studio.regrown(() => page.mouse.move(x + 12, y, { steps: 3 }));
	await page.mouse.up();
	await expect(page).toHaveURL(/p3=.*age=30/);
	await expect(studio.slider("Age")).toHaveValue("30");
});
