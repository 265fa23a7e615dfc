import { expect, test } from "./fixtures";
import { framesRequested } from "./frames";
import { StudioPage } from "./studio_page";

test.use({ drawn: true });

/** Whether two pictures are the same but for the last digit, which compositing at an edge need not give twice. */
const same = (one: Uint8Array, other: Uint8Array) =>
	one.length === other.length && one.every((level, at) => Math.abs(level - other[at]) <= 2);

test("the 3-D view turns by mouse and keys, and comes back to the picture it began with", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
	await expect.poll(() => studio.inkOnCanvas()).toBeGreaterThan(0.02);
	// The rest of the page has arrived: it may still change the first picture.
	await studio.presetsListed();
	await page.waitForLoadState("networkidle");
	/** Without the lowest rows, where the focus ring crosses a button of the view. */
	const drawn = async () => {
		const { data, width } = await studio.pixels();
		return data.subarray(0, data.length - 4 * 6 * width);
	};
	/** The picture at rest and at full resolution, with the focus on it and the mouse away. */
	const settled = async () => {
		await page.mouse.move(0, 0);
		await studio.canvas.focus();
		await expect.poll(() => framesRequested(page)).toBe(0);
		return drawn();
	};
	// The focus ring is shown after a key press, but not after a click.
	await studio.button("Reset view").click();
	const clicked = await settled();
	await page.keyboard.press("0");
	const front = await settled();
	for (const key of ["ArrowRight", "+", "Shift+ArrowUp"]) {
		const before = await drawn();
		await page.keyboard.press(key);
		await expect.poll(async () => same(await drawn(), before)).toBe(false);
	}
	await page.keyboard.press("0");
	await expect.poll(async () => same(await settled(), front)).toBe(true);
	const box = await studio.canvas.boundingBox();
	if (!box) throw new Error("no canvas");
	await page.mouse.move(box.x + 40, box.y + 40);
	await page.mouse.down();
	await page.mouse.move(box.x + 120, box.y + 60, { steps: 3 });
	await page.mouse.up();
	expect(same(await settled(), clicked)).toBe(false);
	await studio.button("Reset view").click();
	await expect.poll(async () => same(await settled(), clicked)).toBe(true);
	expect(page.url()).not.toMatch(/[?&]l=/);
});

test("stems only leaves the berries away", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open();
	await expect.poll(() => studio.inkOnCanvas()).toBeGreaterThan(0.02);
	const whole = await studio.inkOnCanvas();
	await studio.button("Hide berries").click();
	await expect(studio.button("Hide berries")).toHaveAttribute("aria-pressed", "true");
	await expect.poll(() => studio.inkOnCanvas()).toBeLessThan(whole / 2);
	await studio.button("Hide berries").blur();
	await page.keyboard.press("s");
	await expect.poll(() => studio.inkOnCanvas()).toBeGreaterThan(whole / 2);
});

test("the octahedron's handles can be dragged in 3-D, as one undo step", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=grape-15b");
	const first = await studio.fingerprint.innerText();
	await studio.button("Outline in 3D").click();
	await expect(studio.button("Outline in 3D")).toHaveAttribute("aria-pressed", "true");
	await expect.poll(() => studio.lowestHandle()).toBeDefined();
	const tip = await studio.lowestHandle();
	if (!tip) throw new Error("no handle to be seen");
	await page.mouse.move(tip.x, tip.y);
	await page.mouse.down();
	await studio.regrown(() => page.mouse.move(tip.x, tip.y - 30, { steps: 4 }));
	await page.mouse.up();
	await expect(page).toHaveURL(/[?&]l=\d+/);
	expect(Number(await studio.slider("Length").inputValue())).toBeLessThan(377);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(first);
	await expect(studio.button("Undo")).toBeDisabled();
});

test.describe("without the picture", () => {
	test.use({ drawn: false });

	test("the list of shortcuts opens by its key, in French and on a narrow screen, and gives the focus back", async ({
		page,
	}) => {
		await page.setViewportSize({ width: 320, height: 640 });
		await page.addInitScript(() => localStorage.setItem("panicle.ui", '{"language":"fr"}'));
		const studio = await new StudioPage(page).open();
		const help = page.getByRole("button", { name: "Aide" });
		await help.focus();
		await page.keyboard.press("?");
		const dialog = page.getByRole("dialog", { name: "Raccourcis clavier" });
		await expect(dialog).toContainText("Ctrl+Shift+Z");
		await expect(dialog.getByRole("button", { name: "Fermer" })).toBeFocused();
		expect(await dialog.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)).toBeLessThanOrEqual(0);
		expect(await studio.overflow()).toBeLessThanOrEqual(0);
		await page.keyboard.press("Escape");
		await expect(dialog).toBeHidden();
		await expect(help).toBeFocused();
	});

	test("the cursor shows that a drag turns the plant, and that a click removes a berry", async ({ page }) => {
		const studio = await new StudioPage(page).open("?v=2&preset=duku");
		const cursor = () => studio.canvas.evaluate((canvas) => getComputedStyle(canvas).cursor);
		expect(await cursor()).toBe("grab");
		const box = await studio.canvas.boundingBox();
		if (!box) throw new Error("no view");
		await page.mouse.move(box.x + 40, box.y + 40);
		await page.mouse.down();
		await page.mouse.move(box.x + 60, box.y + 50);
		expect(await cursor()).toBe("grabbing");
		await page.mouse.up();
		expect(await cursor()).toBe("grab");
		await page.keyboard.press("t");
		await expect(studio.button("Remove berries")).toHaveAttribute("aria-pressed", "true");
		expect(await cursor()).toBe("crosshair");
	});

	test("a screen reader announces the plant once it rests", async ({ page }) => {
		const studio = await new StudioPage(page).open();
		await studio.regrown(() => studio.slider("Length").press("PageDown"));
		const words = `${await studio.readout("Berries").innerText()} berries`;
		await expect(page.locator("panicle-speaker [role=status]")).toContainText(words);
	});
});
