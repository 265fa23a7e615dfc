import type { Locator, Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage, touchDrag } from "./studio_page";

/** With few and large leaves, which is soon grown. */
const open = async (page: Page, more = "") => {
	const studio = await new StudioPage(page).open(`?v=2&model=grammar&preset=topiary-two-cubes&define=leaf:0.2${more}`);
	await studio.stands();
	return studio;
};
const areasIn = (page: Page) => new URL(page.url()).searchParams.get("areas") ?? "";
const middleOf = async (handle: Locator) => {
	const box = await handle.boundingBox();
	return { x: (box?.x ?? 0) + (box?.width ?? 0) / 2, y: (box?.y ?? 0) + (box?.height ?? 0) / 2 };
};

test("areas are moved and widened by their handles, by keys and by a pointer, and undone", async ({ page }) => {
	const studio = await open(page);
	const before = await studio.fingerprint.textContent();
	const second = page.getByRole("button", { name: /^Area 2, a box: / });
	await second.focus();
	await page.keyboard.press("Shift+ArrowRight");
	await expect(second).toHaveAccessibleName("Area 2, a box: x 0.10, y 2.00, z 0.00");
	await expect.poll(() => areasIn(page)).toContain(";box:0.1,2,0:");
	await expect(studio.fingerprint).not.toHaveText(before ?? "");

	const height = page.getByRole("button", { name: /^Height of area 2: / });
	const { x, y } = await middleOf(height);
	await page.mouse.move(x, y);
	await page.mouse.down();
	await page.mouse.move(x, y - 20, { steps: 4 });
	await page.mouse.move(x, y - 40, { steps: 4 });
	await page.mouse.up();
	await expect.poll(() => Number(/box:0\.1,[^:]*:0\.85,([\d.]+),/.exec(areasIn(page))?.[1])).toBeGreaterThan(0.9);
	await page.keyboard.press("Control+z");
	await expect.poll(() => areasIn(page)).toContain(";box:0.1,2,0:0.85,0.85,0.85");
	await page.keyboard.press("Control+z");
	await expect(studio.fingerprint).toHaveText(before ?? "");
});

test("areas come, change places and go in the panel, by numbers, and from a file", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await open(page);
	await studio.openGroup("Growth areas");
	const list = page.getByRole("list", { name: "Growth areas, in the order of the main branch" });
	await studio.button("Cone").click();
	await expect(list.getByRole("button")).toHaveText(["Area 1, a box", "Area 2, a box", "Area 3, a cone"]);
	await page.getByRole("group", { name: "Rotation, °" }).getByLabel("about z").fill("90");
	await page.getByRole("group", { name: "Rotation, °" }).getByLabel("about z").blur();
	await expect.poll(() => areasIn(page)).toMatch(/cone:0,[\d.]+,0:0\.85,0\.85,0\.85:0,0,0\.7071,0\.7071$/);
	await studio.button("Earlier").click();
	await expect(list.getByRole("button", { pressed: true })).toHaveText("Area 2, a cone");
	await studio.button("Remove area").click();
	await expect(list.getByRole("button")).toHaveText(["Area 1, a box", "Area 2, a box"]);

	const corners = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"];
	const facets = [
		[0, 2, 1],
		[0, 1, 3],
		[0, 3, 2],
		[1, 2, 3],
	].map((facet) => facet.map((k) => `vertex ${corners[k]}`));
	const stlOf = (some: typeof facets) =>
		`solid\n${some.map((facet) => `facet normal 0 0 0\nouter loop\n${facet.join("\n")}\nendloop\nendfacet`).join("\n")}\nendsolid\n`;
	const file = (some: typeof facets) => ({
		name: "tetrahedron.stl",
		mimeType: "model/stl",
		buffer: Buffer.from(stlOf(some)),
	});
	await studio.openGroup("Growth areas");
	const chooser = page.getByLabel("A closed mesh as a growth area");
	await chooser.setInputFiles(file(facets.slice(1)));
	await expect(studio.notices).toContainText("The mesh is not closed: 3 of its edges");
	await chooser.setInputFiles(file(facets));
	await expect(list.getByRole("button")).toHaveText(["Area 1, a box", "Area 2, a box", "Area 3, a mesh"]);
	await expect(studio.notices).toContainText("The mesh is now a growth area");
});

test("the main branch is drawn over the picture, and led back from middle to middle", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await open(page);
	const before = await studio.fingerprint.textContent();
	await studio.openGroup("Growth areas");
	await studio.button("Draw path in the view").click();
	const { x, y } = await middleOf(page.getByRole("application"));
	await page.mouse.move(x, y + 120);
	await page.mouse.down();
	for (const [right, up] of [
		[40, 60],
		[70, 0],
		[20, -60],
		[0, -120],
	])
		await page.mouse.move(x + right, y + up, { steps: 5 });
	await page.mouse.up();
	await expect.poll(() => (new URL(page.url()).searchParams.get("path") ?? "").split(",").length).toBeGreaterThan(8);
	await expect(studio.fingerprint).not.toHaveText(before ?? "");
	await expect(page.getByRole("button", { name: /^Point 1 of the main branch: / })).toBeAttached();
	// One more stroke is a branch that begins at the nearest place.
	await studio.button("Draw fork in the view").click();
	await page.mouse.move(x + 60, y);
	await page.mouse.down();
	for (const [right, up] of [
		[120, -30],
		[150, -90],
	])
		await page.mouse.move(x + right, y + up, { steps: 5 });
	await page.mouse.up();
	await expect(page).toHaveURL(/[?&]from=0,1[,\d]+/);
	await expect(page.getByText("and 1 fork")).toBeVisible();
	await studio.button("Straight path").click();
	await expect(studio.fingerprint).toHaveText(before ?? "");
});

for (const [width, height, hasTouch] of [
	[1440, 900, false],
	[720, 450, false],
	[390, 844, true],
] as const) {
	test.describe(`at ${width} × ${height}`, () => {
		test.use({ viewport: { width, height }, hasTouch });

		test("a handle is dragged and stepped by keys: each one step to undo, and the link brings the plant back", {
			tag: "@long",
		}, async ({ page }) => {
			const studio = await open(page);
			const before = (await studio.fingerprint.textContent()) ?? "";
			const second = page.getByRole("button", { name: /^Area 2, a box: / });
			await expect(second).toBeInViewport({ ratio: 0.99 });
			const from = await middleOf(second);
			if (hasTouch) await touchDrag(page, from, 24, -12);
			else {
				await page.mouse.move(from.x, from.y);
				await page.mouse.down();
				await page.mouse.move(from.x + 24, from.y - 12, { steps: 5 });
				await page.mouse.up();
			}
			await expect(second).not.toHaveAccessibleName("Area 2, a box: x 0.00, y 2.00, z 0.00");
			await expect(studio.fingerprint).not.toHaveText(before);
			await page.keyboard.press("Control+z");
			await expect(studio.fingerprint).toHaveText(before);
			await expect(studio.button("Undo")).toBeDisabled();
			const dragged = await studio.regrown(() => page.keyboard.press("Control+Shift+z"));

			await second.focus();
			await studio.regrown(() => page.keyboard.press("ArrowUp"));
			await page.keyboard.press("Control+z");
			await expect(studio.fingerprint).toHaveText(dragged);
			await expect.poll(() => areasIn(page)).not.toBe("");
			const link = await page.evaluate(() => location.href);
			expect(link).toContain("areas=");
			await page.goto("about:blank");
			await page.goto(link);
			await expect(studio.fingerprint).toHaveText(dragged);
		});
	});
}
