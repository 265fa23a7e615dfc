import { expect, test } from "./fixtures";
import { framesRequested } from "./frames";
import { StudioPage } from "./studio_page";

const WOOD = "?v=2&model=stand&preset=ecosystem-500&many=12";

test("a stand grows, shows its plants on the map, is walked through, changed and brought back", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open(WOOD);
	const caption = page.getByText("12 plants of 5 kinds on 90 × 90 m").first();
	await expect(caption).toBeVisible();
	const before = await studio.fingerprint.textContent();

	const plan = page.getByRole("region", { name: "Map view" });
	await plan.getByRole("spinbutton", { name: "Plant" }).fill("3");
	await plan.getByRole("spinbutton", { name: "Plant" }).press("Enter");
	await expect(plan.getByText(/^Plant 3: [A-Z]/)).toBeVisible();
	await page.keyboard.press("Escape");
	await expect(plan.getByText(/^Plant 3: [A-Z]/)).toHaveCount(0);
	await plan.getByRole("spinbutton", { name: "Plant" }).fill("3");
	await plan.getByRole("spinbutton", { name: "Plant" }).press("Enter");
	const alone = plan.getByRole("link", { name: "Open this plant" });
	await expect(alone).toHaveAttribute("href", /model=growth.*seed=\d+.*&about=/);

	const picture = page.locator("canvas").first();
	const forward = studio.button("Walk forwards");
	for (const leave of [() => page.keyboard.press("Escape"), () => studio.button("Leave").click()]) {
		await studio.button("Walk through").click();
		await expect(picture).toBeFocused();
		// Letters are the walker's, on the picture and on the steps; those of the page rest.
		for (const key of ["w", "ArrowUp", "ArrowLeft", "n"]) await page.keyboard.press(key);
		await expect(picture).toBeFocused();
		await forward.click();
		await page.keyboard.press("w");
		await expect(forward).toBeVisible();
		await expect(studio.fingerprint).toHaveText(before ?? "");
		await leave();
		await expect(forward).toHaveCount(0);
		await expect(picture).toBeFocused();
	}

	await studio.button("New variation").click();
	await expect(studio.fingerprint).not.toHaveText(before ?? "");
	const link = page.url();
	const after = await studio.fingerprint.textContent();
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(before ?? "");
	await page.goto(link);
	await expect(studio.fingerprint).toHaveText(after ?? "");

	// One to which its neighbours are near.
	await page.goto(WOOD);
	await expect(studio.fingerprint).toHaveText(before ?? "");
	await plan.getByRole("spinbutton", { name: "Plant" }).fill("5");
	await plan.getByRole("spinbutton", { name: "Plant" }).press("Enter");
	await alone.click();
	await expect(page.getByText(/, among neighbours/).first()).toBeVisible();
	const among = await studio.fingerprint.textContent();
	await studio.openAdvanced();
	await studio.button("Remove neighbours").click();
	await expect(studio.fingerprint).not.toHaveText(among ?? "");
	await expect(page).not.toHaveURL(/about=/);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(among ?? "");
});

test("a plan is edited; what it asks for and there is not is told at its place, and the last stand stays", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open(WOOD);
	await expect(page.getByText("12 plants of 5 kinds").first()).toBeVisible();
	const before = await studio.fingerprint.textContent();
	await studio.button("Grammar").click();
	const text = page.getByRole("region", { name: "Grammar" }).locator(".cm-content");
	await text.click();
	await page.keyboard.press("ControlOrMeta+End");
	await page.keyboard.insertText("\nlilac/blue, share 900");
	await expect(page.getByText(/There is no model lilac\. The models are bunch/).first()).toBeVisible();
	expect(await studio.fingerprint.textContent()).toBe(before);
	// The faulty line is fully visible above its message.
	const inSight = () =>
		text.evaluate((content) => {
			const view = content.closest(".cm-scroller")?.getBoundingClientRect();
			const line = content.querySelector(".cm-error")?.getBoundingClientRect();
			return view !== undefined && line !== undefined && line.bottom <= view.bottom && line.top >= view.top;
		});
	await expect.poll(inSight).toBe(true);
	await page.keyboard.insertText(", share -1");
	await expect(page.getByText(/outside the range from 0/).first()).toBeVisible();
	expect(await studio.fingerprint.textContent()).toBe(before);
});

test.describe("in the wind", () => {
	test.use({ drawn: true, viewport: { width: 720, height: 450 } });

	test("a stand sways frame by frame while it blows, and not where less motion is wished for", {
		tag: "@long",
	}, async ({ page }) => {
		const studio = await new StudioPage(page).open("?v=2&model=stand&preset=vineyard&many=6");
		await studio.stands();
		const picture = async () => (await page.locator("canvas").first().screenshot()).toString("base64");
		const wind = studio.button("Wind on/off");
		await wind.click();
		await expect(wind).toHaveAttribute("aria-pressed", "true");
		const first = await picture();
		// Software takes seconds to draw a frame of a stand on a busy machine.
		await expect.poll(picture, { timeout: 60_000 }).not.toBe(first);
		await page.emulateMedia({ reducedMotion: "reduce" });
		await expect(wind).toHaveCount(0);
		await expect.poll(() => framesRequested(page)).toBe(0);
	});
});
