import { readdirSync } from "node:fs";
import type { Locator, Page } from "@playwright/test";
import type { PanicleSpecimen } from "../../web/src/element/panicle";
import { gzipped } from "../bench/sizes.mjs";
import { expect, test } from "./fixtures";
import { standInForModelViewer } from "./model_viewer";
import { serveUnder } from "./static_server";
import { StudioPage } from "./studio_page";

const DIST = "dist/assets";

async function openDialog(studio: StudioPage): Promise<Locator> {
	const sheet = await studio.openShare();
	await sheet.getByRole("button", { name: "Copy embed code…" }).click();
	return studio.page.getByRole("dialog", { name: "Copy embed code" });
}

async function copied(page: Page, dialog: Locator): Promise<string> {
	await dialog.getByRole("button", { name: "Copy code" }).click();
	await expect(dialog.getByRole("status")).toHaveText("Copied");
	const code = await page.evaluate(() => navigator.clipboard.readText());
	await expect(dialog.getByRole("textbox", { name: "Code" })).toHaveValue(code);
	return code;
}

/** The fingerprint of the plant in a page or frame that has one. */
const fingerprint = (place: Pick<Page, "waitForFunction">) =>
	place
		.waitForFunction(() => document.querySelector<PanicleSpecimen>("panicle-specimen")?.plant?.fingerprint)
		.then((handle) => handle.jsonValue());

test("copied code shows the plant in a page of another origin, as it was shown: element, frame and file", {
	tag: "@long",
}, async ({ page, context }) => {
	await context.grantPermissions(["clipboard-read", "clipboard-write"]);
	const studio = await new StudioPage(page).open("?v=2&preset=redcurrant&seed=5&count=30");
	const first = await studio.fingerprint.innerText();
	const dialog = await openDialog(studio);
	const preview = dialog.frameLocator("iframe");
	await expect(preview.getByRole("application", { name: /^Redcurrant bunch: .+ with 30 berries/ })).toBeVisible();
	await expect(preview.getByRole("group", { name: "Controls" })).toBeVisible();
	await dialog.getByLabel("Show handles to drag").check();
	await expect(preview.getByRole("group", { name: "Handles" }).getByRole("button")).toHaveCount(5);
	const weight = dialog.getByText(/^Adds/);
	await expect(weight).toHaveText(/^Adds \d+ kB to your page, however many plants the page shows\.$/);
	const all = Number.parseInt((await weight.innerText()).replace("Adds ", ""), 10);
	const wasm = readdirSync(DIST).find((name) => /^bunch-.*\.wasm$/.test(name));
	// three.js alone is larger than this. The element's limit is in the table of sizes.
	expect(all - gzipped(`${DIST}/${wasm}`) / 1000).toBeGreaterThan(100);
	const element = await copied(page, dialog);

	await dialog.getByLabel("Frame", { exact: true }).check();
	await dialog.getByLabel("Width").fill("200");
	const frame = await copied(page, dialog);
	await dialog.getByLabel("<model-viewer>").check();
	await expect(dialog.getByText(/^Adds a GLB of \d/)).toBeVisible();
	const downloading = page.waitForEvent("download");
	await dialog.getByRole("button", { name: "Download redcurrant-5.glb" }).click();
	const glb = await (await downloading).path();
	const viewer = await copied(page, dialog);
	await page.keyboard.press("Escape");
	await expect(page.locator("iframe")).toHaveCount(0);
	await expect(studio.button("Share")).toBeFocused();

	const pages = Object.fromEntries(
		Object.entries({ element, frame, viewer }).map(([name, code]) => [
			`${name}.html`,
			{ html: `<!doctype html><html lang="en"><title>Mine</title><link rel="icon" href="data:,">${code}` },
		]),
	);
	const host = await serveUnder("/none/", "dist", pages);
	const open = (name: string) => page.goto(new URL(`/${name}.html`, host.address).href);
	await open("element");
	expect(await fingerprint(page)).toBe(first);
	await expect(page.getByRole("group", { name: "Handles" }).getByRole("button")).toHaveCount(5);
	await open("frame");
	expect(await page.locator("iframe").evaluate(({ clientWidth, clientHeight }) => [clientWidth, clientHeight])).toEqual(
		[200, 400],
	);
	expect(await fingerprint(page.frames()[1])).toBe(first);
	await standInForModelViewer(page);
	await page.route("**/redcurrant-5.glb", (route) => route.fulfill({ contentType: "model/gltf-binary", path: glb }));
	await open("viewer");
	await page.waitForFunction(() => "gltf" in (document.querySelector("model-viewer") ?? {}));
	const shown = await page.evaluate(() => {
		const { gltf } = document.querySelector("model-viewer") as unknown as {
			gltf: { asset: { extras: { fingerprint: string } }; meshes: object[] };
		};
		return [gltf.asset.extras.fingerprint, gltf.meshes.length > 0];
	});
	expect(shown).toEqual([first, true]);
	await page.goto("about:blank");
	await host.close();
});

test("the dialog is within a small window, and says what whoever copies ought to know", async ({ page }) => {
	await page.addInitScript(() => {
		Object.defineProperty(navigator, "clipboard", {
			value: { writeText: () => Promise.reject(new Error("denied")) },
		});
	});
	const studio = await new StudioPage(page).open("?v=2&model=leaf&preset=birch");
	const dialog = await openDialog(studio);
	await expect(dialog.frameLocator("iframe").getByRole("application", { name: /^Birch leaf/ })).toBeVisible();
	for (const [width, height] of [
		[390, 844],
		[720, 450],
	]) {
		await page.setViewportSize({ width, height });
		const box = await dialog.boundingBox();
		expect(box?.x).toBeGreaterThanOrEqual(0);
		expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(width);
		expect((box?.y ?? 0) + (box?.height ?? 0)).toBeLessThanOrEqual(height);
		expect(await dialog.evaluate((element) => element.scrollWidth - element.clientWidth)).toBe(0);
	}
	await dialog.getByRole("checkbox", { name: "Sway in the wind" }).check();
	await expect(dialog.getByRole("textbox", { name: "Code" })).toHaveValue(/" wind controls /);
	await expect(dialog).toContainText("This model is still a preview");
	await expect(dialog).toContainText("This code points to localhost");
	await dialog.getByRole("button", { name: "Copy code" }).click();
	await expect(dialog.getByRole("status")).toContainText("The code is selected");
	await expect(dialog.getByRole("textbox", { name: "Code" })).toBeFocused();
	for (const role of ["radio", "checkbox", "button", "spinbutton", "textbox"] as const)
		for (const control of await dialog.getByRole(role).all()) await expect(control).toHaveAccessibleName(/\S/);
});

test("Copy picture puts a PNG on the clipboard, and where the browser refuses says what to do instead", {
	tag: "@long",
}, async ({ page, context }) => {
	await context.grantPermissions(["clipboard-read", "clipboard-write"]);
	const studio = await new StudioPage(page).open("?v=2&preset=redcurrant&seed=5&count=30");
	const sheet = await studio.openShare();
	const copy = () => sheet.getByRole("button", { name: "Copy picture" }).click();
	const result = sheet.getByRole("status");
	await copy();
	await expect(result).toHaveText("Picture copied");
	const size = await page.evaluate(async () => {
		const [item] = await navigator.clipboard.read();
		const picture = await createImageBitmap(await item.getType("image/png"));
		return [picture.width, picture.height];
	});
	const box = await studio.canvas.boundingBox();
	expect(size).toEqual([box?.width, box?.height].map((side) => 2 * Math.round(side ?? 0)));
	await page.evaluate(() => {
		navigator.clipboard.write = () => Promise.reject(new DOMException("no", "NotAllowedError"));
	});
	await copy();
	await expect(result).toHaveText("The picture was not copied. Your browser blocked copying. Download it instead.");
	await page.evaluate(() => Reflect.deleteProperty(window, "ClipboardItem"));
	await copy();
	await expect(result).toContainText("Your browser can’t copy pictures.");
});
