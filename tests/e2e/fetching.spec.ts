import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** Makes requests of a pattern fail until they are allowed. */
async function failing(page: Page, pattern: RegExp): Promise<{ allow(): void; failed(): number }> {
	let [open, count] = [false, 0];
	await page.context().route(pattern, (route) => {
		if (open) return route.continue();
		count++;
		return route.fulfill({ status: 503, body: "" });
	});
	return {
		allow: () => {
			open = true;
		},
		failed: () => count,
	};
}

test.beforeEach(({ complaints }) => complaints.expect(/503|file_worker.*ERR_FAILED/));

for (const script of ["viewer", "bunch_figure"]) {
	test(`the 3-D view comes when asked again, where its ${script} did not`, { tag: "@long" }, async ({ page }) => {
		const scene = await failing(page, new RegExp(`assets/${script}-`));
		const studio = await new StudioPage(page).open();
		const trouble = page.getByRole("alert");
		await expect(trouble).toContainText("Part of the app failed to load.");
		await expect(trouble).toContainText("Check your connection and try again, or reload.");
		scene.allow();
		await trouble.getByRole("button", { name: "Try again" }).click();
		await studio.stands();
		await expect(trouble).toHaveCount(0);
		expect(scene.failed()).toBeGreaterThan(0);
	});
}

test("leaves are fetched when a bunch has some; where they did not come, a note says so until they do", {
	tag: "@long",
}, async ({ page }) => {
	const leaf = await failing(page, /assets\/grapevine-/);
	const note = page.getByText("The cane has no leaves");
	const studio = await new StudioPage(page).open("?v=2&preset=riesling");
	await page.waitForLoadState("networkidle");
	expect(leaf.failed()).toBe(0);
	await studio.button("Show cane and leaves").click();
	await expect(note.first()).toBeVisible();
	await expect(studio.button("Show cane and leaves")).toHaveAttribute("aria-pressed", "true");
	expect(leaf.failed()).toBeGreaterThan(0);
	leaf.allow();
	await page.getByRole("button", { name: "New variation" }).click();
	await expect(note).toHaveCount(0);
});

test.describe("to the eye", () => {
	test.use({ drawn: true });

	test("the octahedron comes with the next press, where its script did not", { tag: "@long" }, async ({ page }) => {
		const handles = await failing(page, /assets\/octahedron-/);
		const studio = await new StudioPage(page).open();
		await studio.button("Outline in 3D").click();
		await expect(studio.notices).toContainText("The 3D outline could not be loaded");
		await expect(studio.button("Outline in 3D")).toHaveAttribute("aria-pressed", "false");
		handles.allow();
		await studio.button("Outline in 3D").click();
		await expect.poll(() => studio.lowestHandle()).toBeDefined();
		await expect(studio.button("Outline in 3D")).toHaveAttribute("aria-pressed", "true");
		expect(handles.failed()).toBe(1);
	});
});

test("Back to a tree whose scripts cannot be fetched fetches each of them once", async ({ page, complaints }) => {
	complaints.expect(/ERR_FAILED/);
	// A leaf grows by the module that the tree needs, so that the tree grows, too: only its scripts are missing.
	const studio = await new StudioPage(page).open("?v=2&model=leaf");
	await page.evaluate(() => {
		history.pushState(null, "", "?v=2&model=tree&preset=twin");
		history.pushState(null, "", "?v=2&model=grammar&seed=83247");
		dispatchEvent(new PopStateEvent("popstate"));
	});
	await expect(page).toHaveTitle(/83247 · Panicle/);
	await expect(page.getByRole("application", { name: /^Grammar/ })).toBeVisible();
	const requests: string[] = [];
	await page.context().route(/assets\//, (route) => {
		requests.push(route.request().url());
		return route.abort();
	});
	await page.goBack();
	await expect(studio.notices).toContainText("This plant cannot be drawn yet");
	// Without end, they would be hundreds in so many frames.
	await page.evaluate(async () => {
		for (let frame = 0; frame < 60; frame++) await new Promise(requestAnimationFrame);
	});
	const times = (script: string) => requests.filter((url) => url.includes(`/${script}-`)).length;
	expect(times("tree_renderer")).toBe(1);
	expect(Math.max(...requests.map((url) => requests.filter((other) => other === url).length))).toBeLessThanOrEqual(2);
});

test("the tools come when asked again, where their script did not", async ({ page }) => {
	const tools = await failing(page, /assets\/ui-/);
	const studio = new StudioPage(page);
	await page.goto("./?v=2");
	await expect(studio.notices).toContainText("This plant’s tools could not be loaded");
	tools.allow();
	await studio.notices.getByRole("button", { name: "Try again" }).click();
	await expect(studio.slider("Age")).toBeVisible();
	await expect(studio.notices.getByRole("button", { name: "Try again" })).toHaveCount(0);
});

test("a file is made when asked again, where the script that writes it did not come", { tag: "@long" }, async ({
	page,
}) => {
	const exporter = await failing(page, /assets\/file_worker-/);
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	await studio.chooseFormat("obj");
	await expect(studio.notices).toContainText("Could not create this file: OBJ with MTL");
	await expect(studio.notices).toContainText("Check your connection and try again");
	exporter.allow();
	const downloading = page.waitForEvent("download");
	await studio.notices.getByRole("button", { name: "Try again" }).click();
	expect((await downloading).suggestedFilename()).toBe("lychee-1-obj.zip");
	// For the file, and perhaps before it for the sizes in the sheet.
	expect(exporter.failed()).toBeLessThanOrEqual(2);
});

test("a file that takes its time says so, can be cancelled, and holds nothing else up", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	let release = () => {};
	const held = new Promise<void>((resolve) => {
		release = resolve;
	});
	await page.context().route(/assets\/file_worker-/, async (route) => {
		await held;
		await route.abort();
	});
	await studio.chooseFormat("glb");
	await expect(page.getByRole("progressbar", { name: "Preparing the file" })).toBeVisible();
	await expect(page.getByText("Preparing GLB…")).toBeVisible();
	const { width, height } = page.viewportSize() ?? { width: 800, height: 500 };
	for (const size of [
		{ width: 320, height: 568 },
		{ width, height },
	]) {
		await page.setViewportSize(size);
		await expect(page.getByText("Preparing GLB…")).toBeInViewport({ ratio: 0.99 });
		await expect(studio.button("Cancel the download")).toBeInViewport({ ratio: 0.99 });
	}
	await studio.regrown(() => studio.slider("Length").press("PageDown"));
	await studio.button("Cancel the download").click();
	await expect(page.getByRole("progressbar", { name: "Preparing the file" })).toHaveCount(0);
	await expect(studio.notices).not.toContainText("Could not create");
	release();
	await page.context().unrouteAll({ behavior: "ignoreErrors" });
	const { bytes } = await studio.download("glb");
	expect(bytes.toString("latin1", 0, 4)).toBe("glTF");
});
