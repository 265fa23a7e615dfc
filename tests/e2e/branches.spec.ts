import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** A small tree without leaves, which is soon grown. */
const TREE = "?v=2&model=growth&preset=apple&season=0&steps=5";

const editsIn = (page: Page) => new URL(page.url()).searchParams.get("edit") ?? "";
const view = (page: Page) => page.getByRole("application");
const chooser = (page: Page) => page.getByRole("spinbutton", { name: "Branch", exact: true });

/** Opens the tree and starts to edit it. */
async function open(page: Page, search = TREE): Promise<StudioPage> {
	const studio = await new StudioPage(page).open(search);
	await studio.stands();
	await studio.button("Edit branches").click();
	await expect(studio.button("Edit branches")).toHaveAttribute("aria-pressed", "true");
	return studio;
}

/** Clicks up the middle of the tree until a branch or the trunk is chosen. */
async function clickBranch(page: Page): Promise<void> {
	const box = await view(page).boundingBox();
	if (!box) throw new Error("no canvas");
	await expect(async () => {
		for (let row = 0; row < 6; row++) {
			await page.mouse.click(box.x + box.width * 0.5, box.y + box.height * (0.7 - 0.07 * row));
			if (/^(Branch|Trunk) \d/.test(await chooser(page).innerText())) return;
		}
		throw new Error("no branch under the pointer");
	}).toPass();
}

test("a branch is pruned by the mouse; undo, reload and the link in another window know of it", async ({
	page,
	context,
}) => {
	const studio = await open(page);
	const whole = await studio.fingerprint.innerText();
	await clickBranch(page);
	const pruned = await studio.regrown(() => studio.button("Prune").click());
	await expect.poll(() => editsIn(page)).toMatch(/^1\.p[\w-]{12}$/);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(whole);
	await studio.button("Redo").click();
	await expect(studio.fingerprint).toHaveText(pruned);
	await page.reload();
	await expect(studio.fingerprint).toHaveText(pruned);
	const other = await new StudioPage(await context.newPage()).open(new URL(page.url()).search);
	await expect(other.fingerprint).toHaveText(pruned);
});

test("branches are chosen, broken, made dead and reset by keyboard, and Escape leaves", async ({ page }) => {
	const studio = await open(page);
	const whole = await studio.fingerprint.innerText();
	await chooser(page).focus();
	await page.keyboard.press("ArrowRight");
	await expect(chooser(page)).toHaveAttribute("aria-valuetext", /^Trunk 1 of 1, /);
	await page.keyboard.press("ArrowUp");
	await expect(chooser(page)).toHaveAttribute("aria-valuetext", /^Branch 1 of \d+ on the trunk, /);
	await page.keyboard.press("ArrowRight");
	await expect(chooser(page)).toHaveAttribute("aria-valuetext", /^Branch 2 of \d+ on the trunk, /);
	await studio.regrown(() => page.keyboard.press("b"));
	await expect.poll(() => editsIn(page)).toMatch(/^1\.b[\w-]{12}$/);
	await studio.regrown(() => page.keyboard.press("r"));
	await expect(studio.fingerprint).toHaveText(whole);
	await page.keyboard.press("d");
	await expect.poll(() => editsIn(page)).toMatch(/^1\.d[\w-]{11}$/);
	await expect(studio.button("Dead")).toHaveAttribute("aria-pressed", "true");
	await studio.openGroup("Shoots");
	await page.getByRole("button", { name: /^Remove the edit “Dead: Branch 2 of / }).click();
	await expect.poll(() => editsIn(page)).toBe("");
	await expect(studio.fingerprint).toHaveText(whole);
	await chooser(page).focus();
	await page.keyboard.press("Escape");
	await page.keyboard.press("Escape");
	await expect(studio.button("Edit branches")).toHaveAttribute("aria-pressed", "false");
});

test("the trunk is bent by its tip, by keys and by the mouse, and drawn with a stroke", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await open(page);
	await chooser(page).focus();
	await page.keyboard.press("ArrowUp");
	const tip = page.getByRole("button", { name: /^Tip of the branch: / });
	await tip.focus();
	await studio.regrown(() => page.keyboard.press("Shift+ArrowRight"));
	await expect.poll(() => editsIn(page)).toMatch(/^1\.c[\w-]+$/);
	const before = editsIn(page);
	const box = await tip.boundingBox();
	const [x, y] = [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
	await page.mouse.move(x, y);
	await page.mouse.down();
	await page.mouse.move(x + 40, y + 10, { steps: 4 });
	await page.mouse.up();
	await expect.poll(() => editsIn(page)).not.toBe(before);
	const bent = editsIn(page);
	await studio.button("Draw").click();
	const canvas = await view(page).boundingBox();
	const [left, top] = [(canvas?.x ?? 0) + (canvas?.width ?? 0) / 2, (canvas?.y ?? 0) + (canvas?.height ?? 0) * 0.6];
	await page.mouse.move(left, top);
	await page.mouse.down();
	for (const [right, up] of [
		[-30, 40],
		[-20, 100],
		[40, 160],
	])
		await page.mouse.move(left + right, top - up, { steps: 5 });
	await page.mouse.up();
	await expect.poll(() => editsIn(page)).not.toBe(bent);
	await studio.button("Undo").click();
	await expect.poll(() => editsIn(page)).toBe(bent);
});
