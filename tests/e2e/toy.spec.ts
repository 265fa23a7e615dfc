import { execFileSync } from "node:child_process";
import { validateBytes } from "gltf-validator";
import { expect, test } from "./fixtures";
import { serveUnder } from "./static_server";
import { StudioPage } from "./studio_page";

/** The app with a model that it does not know by itself: tests/toy. */
let host: Awaited<ReturnType<typeof serveUnder>>;

test.beforeAll(async () => {
	execFileSync(process.execPath, ["node_modules/vite/bin/vite.js", "build", "--config", "tests/toy/vite.config.ts"]);
	host = await serveUnder("/", "build/toy");
});
test.afterAll(() => host.close());

test("a model of three files is shown, edited, linked, undone and downloaded", async ({ page }) => {
	const studio = new StudioPage(page);
	await page.goto(`${host.address}?model=toy`);
	await expect(studio.fingerprint).toHaveText(/^[0-9a-f]{16}$/);
	await expect(page).toHaveTitle("Upright shrub 1 · Panicle");
	await expect(page.getByRole("application", { name: /^Toy shrub: 40 twigs, 27 fruits/ })).toBeVisible();
	await studio.stands();

	const upright = await studio.fingerprint.innerText();
	const spread = studio.slider("Spread");
	await studio.regrown(() => spread.press("ArrowRight"));
	await expect(page).toHaveURL(/model=toy&a=16$/);
	await studio.regrown(() => studio.button("Undo").click());
	await expect(studio.fingerprint).toHaveText(upright);

	const { bytes } = await studio.download("glb");
	const { issues } = await validateBytes(new Uint8Array(bytes));
	expect([issues.numErrors, issues.numWarnings]).toEqual([0, 0]);
});

test("a preset of another model brings that model, and undo goes back across", { tag: "@long" }, async ({ page }) => {
	const studio = new StudioPage(page);
	await page.goto(`${host.address}?v=2`);
	await expect(studio.fingerprint).toHaveText(/^[0-9a-f]{16}$/);
	const bunch = await studio.fingerprint.innerText();
	await expect(studio.slider("Berry width")).toBeVisible();
	await page.getByRole("button", { name: "Browse presets" }).click();
	await page.getByRole("searchbox", { name: "Search presets" }).fill("open shrub");
	await studio.regrown(() => page.getByRole("dialog").locator("[data-preset=open]").click());
	await expect(page).toHaveTitle("Open shrub 1 · Panicle");
	await expect(page).toHaveURL(/model=toy&preset=open$/);
	await expect(studio.slider("Spread")).toHaveValue("60");
	await expect(studio.slider("Berry width")).toHaveCount(0);
	await studio.regrown(() => studio.button("Undo").click());
	await expect(studio.fingerprint).toHaveText(bunch);
	await expect(studio.slider("Berry width")).toBeVisible();
});
