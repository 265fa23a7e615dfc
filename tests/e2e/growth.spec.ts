import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const caption = /(\d+(?:\.\d+)?) m tall, (\d+) branches/;

test("a growth volume is stretched by its handle: the text follows, undo and the link bring the tree back", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&model=growth&preset=table-1-sigma1&steps=5");
	const words = page.getByText(caption).first();
	await expect(words).toBeVisible();
	const tall = async () => Number(caption.exec((await words.textContent()) ?? "")?.[1]);
	const branches = async () => caption.exec((await words.textContent()) ?? "")?.[2];
	const [before, count] = [await tall(), await branches()];
	const height = page.getByRole("button", { name: /^Height of growth volume 1/ });
	await studio.regrown(() => height.press("Shift+ArrowUp"));
	await expect.poll(tall).toBeGreaterThan(before + 0.5);
	// How many there are does not depend on where they find room.
	expect(await branches()).toBe(count);
	await expect(height).toHaveAccessibleName(/11\.0 m/);
	await studio.button("Grammar").click();
	await expect(page.getByRole("region", { name: "Grammar" }).locator(".cm-content")).toContainText(
		"footprint -> GrowVol(1, 1, 8, 11, 5, 0, towards(0), at(0, 0))",
	);
	// The model has no derivation steps.
	await expect(page.getByRole("button", { name: "Steps", exact: true })).toHaveCount(0);
	await studio.button("Close the grammar").click();
	const grown = await studio.fingerprint.textContent();
	const link = page.url();
	await studio.button("Undo").click();
	await expect.poll(tall).toBe(before);
	await page.goto(link);
	await expect(studio.fingerprint).toHaveText(grown ?? "");
});

test("a mistake in the text is reported at its place, and the last tree stays", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=growth&preset=figure-5&steps=4");
	await studio.button("Grammar").click();
	const text = page.getByRole("region", { name: "Grammar" }).locator(".cm-content");
	await text.click();
	await page.keyboard.press("ControlOrMeta+End");
	const before = await studio.fingerprint.textContent();
	await page.keyboard.insertText("\ntree -> Leaves(3)");
	await expect(page.getByText(/A tree consists of divisor functions/).first()).toBeVisible();
	expect(await studio.fingerprint.textContent()).toBe(before);
});

test("the year goes round by one slider: bare in winter, in flower in spring, and undo and the link bring it back", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=growth&preset=apple&steps=5");
	const words = page.getByText(caption).first();
	await expect(words).toContainText(/[1-9]\d* blossoms/);
	const spring = await studio.fingerprint.textContent();
	const season = studio.slider("Season");
	await studio.regrown(() => season.fill("1"));
	await expect(words).toContainText("bare");
	const winter = await studio.fingerprint.textContent();
	const link = page.url();
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(spring ?? "");
	await page.goto(link);
	await expect(studio.fingerprint).toHaveText(winter ?? "");
});
