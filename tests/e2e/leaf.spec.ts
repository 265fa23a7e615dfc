import { validateBytes } from "gltf-validator";
import { drawnBlade } from "./drawn_picture";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** The middle of a point of the outline, in pixels of the page. */
async function gripOf(studio: StudioPage, index: number): Promise<{ x: number; y: number }> {
	const box = await studio.page.locator(`panicle-outline [data-handle="${index}"]`).boundingBox();
	if (!box) throw new Error(`Point ${index} is not on the page.`);
	return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

test("a leaf's outline is dragged, stepped by keys, undone, and linked", async ({ page }) => {
	const studio = await new StudioPage(page).open("?model=leaf");
	await expect(page).toHaveTitle("Grapevine 1 · Panicle");
	await expect(page.getByRole("application", { name: /^Leaf: Grapevine leaf, \d+ cm²/ })).toBeVisible();
	const published = await studio.fingerprint.innerText();

	const from = await gripOf(studio, 6);
	await page.mouse.move(from.x, from.y);
	await page.mouse.down();
	await page.mouse.move(from.x + 6, from.y + 8, { steps: 4 });
	await studio.regrown(() => page.mouse.up());
	await expect(page).toHaveURL(/model=leaf&o=~[\w-]+$/);
	expect(page.url().length).toBeLessThan(300);
	const to = await gripOf(studio, 6);
	expect(to.x - from.x).toBeCloseTo(6, 0);
	expect(to.y - from.y).toBeCloseTo(8, 0);

	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(published);
	await expect(page).toHaveURL(/model=leaf$/);

	await studio.regrown(() => page.locator('panicle-outline [data-handle="6"]').press("Shift+ArrowUp"));
	await expect(page.locator('panicle-outline [data-handle="6"]')).toBeFocused();
	const points = page.locator("panicle-outline [data-handle]");
	const before = await points.count();
	await studio.regrown(() => page.keyboard.press("Insert"));
	await expect(points).toHaveCount(before + 2);
	await studio.regrown(() => page.keyboard.press("Delete"));
	await expect(points).toHaveCount(before);
});

test("Escape calls off a drag, and the lock lets go of the other side", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?model=leaf&preset=lime");
	const published = await studio.fingerprint.innerText();
	const from = await gripOf(studio, 4);
	await page.mouse.move(from.x, from.y);
	await page.mouse.down();
	await page.mouse.move(from.x - 20, from.y, { steps: 3 });
	await page.keyboard.press("Escape");
	await page.mouse.up();
	await expect(studio.fingerprint).toHaveText(published);
	await expect(studio.button("Undo")).toBeDisabled();

	await studio.button("Keep both sides symmetrical").click();
	await studio.regrown(() => page.locator('panicle-outline [data-handle="4"]').press("Shift+ArrowLeft"));
	await expect(page).toHaveURL(/preset=lime&o=[\w-]+$/);
	await studio.regrown(() => studio.button("Keep both sides symmetrical").click());
	await expect(page).toHaveURL(/preset=lime&o=~[\w-]+$/);
});

test("a leaf is downloaded as GLB, JSON and SVG", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?model=leaf&preset=oak");
	await studio.stands();
	const glb = await studio.download("glb");
	expect(glb.name).toBe("oak-1.glb");
	const { issues } = await validateBytes(new Uint8Array(glb.bytes));
	expect([issues.numErrors, issues.numWarnings]).toEqual([0, 0]);
	const json = JSON.parse((await studio.download("json")).bytes.toString());
	expect(json.counts.energy).toBe(json.counts.particles);
	const svg = await studio.download("svg");
	expect(svg.name).toBe("oak-1-veins.svg");
	expect(svg.bytes.toString()).toContain("<title>Oak leaf, ");
});

test("a picture's leaf is traced, and what is none is refused in plain words", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?model=leaf");
	const picture = await drawnBlade(page);
	await studio.openAdvanced();
	const [chooser] = await Promise.all([page.waitForEvent("filechooser"), studio.button("Trace a picture…").click()]);
	await studio.regrown(() => chooser.setFiles({ name: "leaf.png", mimeType: "image/png", buffer: picture }));
	await expect(studio.notices).toContainText(/Traced an outline of \d+ points/);
	await expect(studio.notices).toContainText("Teeth is 0 now");
	await expect(studio.notices).toContainText("The stalk in the picture is the petiole");
	await expect(studio.measure("slenderness")).toContainText(/1\.[56]\d/);

	await studio.drop("no.png", Buffer.from("no picture"));
	await expect(studio.notices).toContainText("The file is not a picture that this browser can read");
});
