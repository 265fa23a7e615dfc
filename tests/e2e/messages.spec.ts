import { compressText } from "../../web/src/specimen/compressed_text";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const CUBES = "?v=2&model=grammar&preset=topiary-two-cubes&define=leaf:0.2";
const over = ".stage-warnings";

test("of a topiary a text beside the picture lists missed areas and those that were moved", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open(`${CUBES}&path=0,0,0,5,0.1,0,5,0.2,0`);
	await studio.stands();
	await expect(page.locator(over)).toContainText("Area 2 stays empty, because the main branch does not reach it.");
	await studio.openGroup("Growth areas");
	await studio.button("Straight path").click();
	await expect(page.locator(over)).toHaveText("");

	// The handles are there from the first.
	const second = page.getByRole("button", { name: /^Area 2, a box: / });
	await second.focus();
	const status = page.locator(".plant-handles [role=status]");
	for (const x of ["−0.01", "−0.02"]) {
		await page.keyboard.press("ArrowLeft");
		await expect(status).toHaveText(`x ${x.replace("−", "-")}, y 2.00, z 0.00`);
		await expect(second).toHaveAccessibleName(`Area 2, a box: x ${x.replace("−", "-")}, y 2.00, z 0.00`);
	}

	await page.keyboard.press("Delete");
	const first = page.getByRole("button", { name: /^Area 1, a box: / });
	await expect(second).toHaveCount(0);
	await expect(page.locator(".plant-handles :focus")).toHaveCount(1);
	await page.keyboard.press("Control+z");
	await expect(second).toHaveCount(1);

	const list = page.getByRole("list", { name: "Growth areas, in the order of the main branch" });
	const box = page.getByRole("complementary", { name: "Controls" }).getByRole("button", { name: "Box", exact: true });
	for (const left of [1, 0]) {
		await list.getByRole("button").last().click();
		await studio.button("Remove area").focus();
		await page.keyboard.press("Enter");
		await expect(list.getByRole("button")).toHaveCount(left);
		await expect(left > 0 ? list.getByRole("button") : box).toBeFocused();
	}
	await expect(first).toHaveCount(0);
	await expect(page.locator(over)).toContainText("There is no growth area");
});

test("the editor of a text that cannot be grown is offered where the plant would be, and said where its link is shared", async ({
	page,
}) => {
	const packed = await compressText("axiom: F(\n");
	await page.goto(`./?v=2&model=grammar#g=${packed}`);
	const alert = page.getByRole("alert");
	await expect(alert).toContainText("The plant can’t be grown with this setting");
	const studio = new StudioPage(page);
	await expect(await studio.openShare()).toContainText("so the link will not show it");
	await page.keyboard.press("Escape");
	await alert.getByRole("button", { name: "Edit the grammar" }).click();
	const text = page.getByRole("textbox", { name: "Grammar" });
	await expect(text).toBeFocused();
	await expect(page.getByText("has its own grammar")).toHaveCount(0);
	// It was opened by a button that has gone; by its key it is left to the one that stands for it.
	await page.keyboard.press("Escape");
	await page.keyboard.press("Enter");
	await expect(text).toHaveCount(0);
	await expect(page.getByText("has its own grammar")).toHaveCount(1);
	await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
	await page.keyboard.press("g");
	await expect(text).toBeFocused();
	await page.keyboard.press("Escape");
	await page.keyboard.press("Enter");
	await expect(studio.button("Grammar")).toBeFocused();
});

test("a picture without a plant brings a message on what this model accepts", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open(CUBES);
	const png = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==";
	await studio.drop("a.png", Buffer.from(png, "base64"));
	await expect(studio.notices).toContainText(".xml) can be opened at any time");
	await expect(studio.notices).toContainText(/Grammar: Drop a closed mesh .* to add it as a growth area/);
});

test("of very many remarks some are listed, and all are marked", { tag: "@long" }, async ({ page }) => {
	const lines = Array.from({ length: 300 }, (_, i) => `X${i} --> F [ F${i} ]`);
	const studio = await new StudioPage(page).open(
		`?v=2&model=grammar#g=${await compressText(["axiom: A", ...lines].join("\n"))}`,
	);
	await expect(page.locator(".readout .notes")).toContainText("more.");
	await page.keyboard.press("g");
	const messages = page.locator(".pane-messages");
	await expect(messages.getByRole("button")).toHaveCount(50);
	await expect(messages).toContainText("250 more problems are marked in the grammar.");
	await expect(messages).toContainText(
		"The grammar does not draw anything; add a symbol that draws, such as “F” for a line.",
	);
	await expect(page.locator(over)).toContainText(
		"The grammar does not draw anything; add a symbol that draws, such as “F” for a line.",
	);
	await expect(studio.button("Grammar")).toHaveAttribute("aria-pressed", "true");
});
