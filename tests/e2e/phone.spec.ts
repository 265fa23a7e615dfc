import { expect, test } from "./fixtures";
import { StudioPage, touchDrag } from "./studio_page";

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

test.describe("to the eye", () => {
	test.use({ drawn: true });

	test("the picture keeps its proportions when the views beside it take up room", async ({ page }) => {
		await new StudioPage(page).open("?v=2&model=growth&preset=figure-5");
		const picture = page.locator("panicle-stage").getByRole("application");
		const stretch = () =>
			picture.evaluate(
				(canvas: HTMLCanvasElement) => canvas.width / canvas.height / (canvas.clientWidth / canvas.clientHeight),
			);
		await expect.poll(stretch).toBeCloseTo(1, 1);
	});

	test("one flat view at a time, chosen by a switch, the plant beside it", { tag: "@long" }, async ({ page }) => {
		const studio = await new StudioPage(page).open();
		const front = page.getByRole("region", { name: "Front view" });
		const side = page.getByRole("region", { name: "Side view" });
		await expect(studio.canvas).toBeVisible();
		await expect(front).toBeHidden();
		await page.getByRole("radio", { name: "Front" }).check();
		await expect(front).toBeVisible();
		await expect(side).toBeHidden();
		await expect.poll(async () => (await studio.canvas.boundingBox())?.width).toBeLessThan(150);
		await expect.poll(() => studio.inkOnCanvas()).toBeGreaterThan(0.02);
		await page.getByRole("radio", { name: "Side" }).check();
		await expect(side).toBeVisible();
		await page.getByRole("radio", { name: "3D" }).check();
		await expect(studio.canvas).toBeVisible();
		await expect.poll(() => studio.inkOnCanvas()).toBeGreaterThan(0.02);
	});
});

test("a thumb drags a handle, and that is one undo step", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const first = await studio.fingerprint.innerText();
	await page.getByRole("radio", { name: "Front" }).check();
	const grip = await studio.grip("Front", "p3");
	await studio.regrown(() => touchDrag(page, grip, 40, 20));
	await expect(page).toHaveURL(/p3=/);
	await studio.button("Undo").tap();
	await expect(studio.fingerprint).toHaveText(first);
	await expect(studio.button("Undo")).toBeDisabled();
});

test("the age is at hand, whatever of the sheet is in sight", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open();
	await page.locator(".sheet").evaluate((sheet) => sheet.scrollBy(0, 900));
	await expect(studio.slider("Age")).toBeInViewport();
	await studio.regrown(() => studio.button("Play").tap());
	await expect(studio.button("Pause")).toBeInViewport();
	await studio.button("Pause").tap();
});

test("the sheet holds the gallery and every group, with targets for a thumb", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	await studio.regrown(() => page.getByRole("button", { name: "Cylindrical", exact: true }).tap());
	await studio.openGroup("Branching");
	await studio.slider("Yaw").scrollIntoViewIfNeeded();
	await expect(studio.slider("Yaw")).toBeInViewport();
	await studio.openGroup("Look");
	const targets = page.locator("button:visible, input[type=range]:visible, summary:visible");
	expect(await targets.count()).toBeGreaterThan(20);
	const small = await targets.evaluateAll((elements) =>
		elements
			.filter((element) => element.getBoundingClientRect().height < 44)
			.map((element) => element.ariaLabel ?? element.textContent ?? element.id),
	);
	expect(small).toEqual([]);
	expect(await studio.overflow()).toBeLessThanOrEqual(0);
});

test("a thumb moves a leaf's point and a tree's target, and takes particles a step on", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?model=leaf&preset=lime&n=200");
	const pull = async (view: string, editor: string, handle: string) => {
		await page.getByRole("radio", { name: view }).check();
		const grip = await studio.grip(view, handle);
		await studio.regrown(() => touchDrag(page, grip, -25, 15));
		for (const target of await page.locator(`${editor} button:visible, .transport > *`).all()) {
			const { width = 0, height = 0 } = (await target.boundingBox()) ?? {};
			const name = await target.getAttribute("aria-label");
			expect(Math.round(Math.min(width, height)), name ?? "").toBeGreaterThanOrEqual(44);
		}
		await studio.button("Undo").tap();
		await expect(studio.button("Undo")).toBeDisabled();
	};
	await pull("Outline", "panicle-outline", "4");
	await page.getByRole("combobox", { name: "Speed" }).selectOption("0.25 ×");
	await expect(studio.button("Play")).toBeInViewport();
	await studio.regrown(() => studio.button("Step").tap());
	await expect(studio.slider("Age")).toHaveValue("0");
	await studio.regrown(() => studio.button("Step").tap());
	expect(await studio.overflow()).toBeLessThanOrEqual(0);

	await studio.open("?model=tree&preset=sphere&n=60");
	await pull("Boundary", "panicle-boundary", "target0");
	expect(await studio.overflow()).toBeLessThanOrEqual(0);
});
