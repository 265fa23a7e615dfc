import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("the name of a tool is shown by hover and focus, hidden by Escape, and shown on request for good", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const name = page.locator(".tool-name", { hasText: "Hide berries" });
	await expect(name).toBeHidden();
	await studio.button("Hide berries").hover();
	await expect(name).toBeVisible();
	await page.keyboard.press("Escape");
	await expect(name).toBeHidden();
	await studio.slider("Length").focus();
	await studio.button("Reset view").focus();
	for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowDown");
	await expect(studio.button("Hide berries")).toBeFocused();
	await expect(name).toBeVisible();
	await page.keyboard.press("Escape");
	await expect(name).toBeHidden();
	await studio.button("Show tool names").click();
	await expect(name).toBeVisible();
	await expect(page.locator(".tool-name:visible")).toHaveText([
		"Reset view",
		"Wind on/off",
		"Show tool names",
		"Measure",
		"Present the plant",
		"Hide berries",
		"Show cane and leaves",
		"Outline in 3D",
		"Remove berries",
		"Grammar",
	]);
	await page.reload();
	await expect(name).toBeVisible();
});

test.describe("in a wide window", () => {
	test.use({ viewport: { width: 1280, height: 800 } });

	test("the button of the grammar always shows its name", async ({ page }) => {
		await new StudioPage(page).open("?v=2&preset=cylindrical");
		await expect(page.locator(".tool-name:visible")).toHaveText(["Grammar"]);
	});
});

test("tools have the same order and places in every model", { tag: "@long" }, async ({ page }) => {
	// High enough for all tools of each model in one column.
	await page.setViewportSize({ width: 1280, height: 800 });
	const places = async (query: string) => {
		const studio = await new StudioPage(page).open(query);
		const slots = page.getByRole("toolbar", { name: "3D view" }).getByRole("group");
		await expect(slots.first()).toBeVisible();
		const names = await slots.evaluateAll((groups) => groups.map(({ ariaLabel }) => ariaLabel));
		const boxes = ["Reset view", "Wind on/off", "Grammar"].map((name) => studio.button(name).boundingBox());
		return { names, boxes: await Promise.all(boxes) };
	};
	const [bunch, growth, grammar] = [
		await places("?v=2&preset=cylindrical"),
		await places("?model=growth&preset=figure-5"),
		await places("?model=grammar&preset=shrub"),
	];
	expect(bunch.names).toEqual(["View", "Edit", "Source"]);
	expect(growth.names).toEqual(["View", "Edit", "Gestures", "Source"]);
	expect(grammar.names).toEqual(["View", "Gestures", "Source"]);
	for (let i = 0; i < bunch.boxes.length; i++) {
		expect(growth.boxes[i]).toMatchObject({ x: bunch.boxes[i]?.x });
		expect(grammar.boxes[i]).toMatchObject({ x: bunch.boxes[i]?.x });
	}
	for (const { boxes } of [growth, grammar]) expect(boxes.slice(0, 2)).toEqual(bunch.boxes.slice(0, 2));
});

test.describe("on a phone", () => {
	test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

	test("the names of all tools are whole, on their buttons", async ({ page }) => {
		const studio = await new StudioPage(page).open("?v=2&model=growth&preset=figure-5");
		await studio.button("Show tool names").tap();
		const names = page.locator(".tool-name:visible");
		await expect(names).toHaveCount(11);
		const hidden = await names.evaluateAll((all) =>
			all
				.filter((name) => {
					const { left, right, top, bottom } = name.getBoundingClientRect();
					const corners = [
						[left + 1, top + 1],
						[right - 1, bottom - 1],
					];
					return corners.some(([x, y]) => !name.parentElement?.contains(document.elementFromPoint(x, y)));
				})
				.map(({ textContent }) => textContent),
		);
		expect(hidden).toEqual([]);
	});
});
