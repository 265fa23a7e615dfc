/** The share sheet and the download sheet. */
import decodeQR from "qr/decode.js";
import { compressText } from "../../web/src/specimen/compressed_text";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const REDCURRANT = "?v=2&preset=redcurrant&seed=5&count=30";

test("the download sheet recommends one file for each purpose, with its size, and one press downloads it", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open(REDCURRANT);
	const sheet = await studio.openDownloads();
	const purposes = sheet.getByRole("list", { name: "What will you use it for?" }).getByRole("button");
	await expect(purposes.first()).toBeFocused();
	await expect(purposes.first()).toHaveAccessibleName(/^3D program .*GLB Opens in Blender and most other 3D programs$/);
	const data = sheet.getByRole("button", { name: /^Data .*Berries as CSV Opens in Excel/ });
	await expect(data.locator(".size")).toHaveText(/^\d+ kB$/, { timeout: 60_000 });
	const size = await data.locator(".size").innerText();
	const { name, bytes } = await studio.downloaded(() => data.press("Enter"));
	expect(name).toBe("redcurrant-altered-5-berries.csv");
	expect(size).toBe(`${Math.max(1, Math.round(bytes.length / 1000))} kB`);
	await expect(sheet).toBeHidden();
	await expect(studio.button("Download")).toBeFocused();
	await expect(studio.notices).toContainText("Downloaded redcurrant-altered-5-berries.csv");
});

test("of a leaf, the download sheet recommends the files that a leaf has", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=leaf&preset=birch");
	const sheet = await studio.openDownloads();
	await expect(sheet.getByRole("button", { name: /^Data .*JSON Opens in Python/ })).toBeVisible();
	await expect(sheet.locator("[data-format=svg]")).toHaveAccessibleName(/^Veins as SVG/);
	await page.keyboard.press("Escape");
	await expect(sheet).toBeHidden();
	await expect(studio.button("Download")).toBeFocused();
});

test("options are beside their file and change only that file", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open(REDCURRANT);
	const sheet = await studio.openDownloads();
	const size = (key: string) => sheet.locator(`[data-format=${key}] .size`);
	await expect(size("glb-low")).toHaveText(/B$/, { timeout: 60_000 });
	const before = await size("glb-low").innerText();
	const low = sheet.getByRole("group", { name: "Options for Low-poly GLB" });
	await low.getByLabel("Triangles").fill("500");
	await low.getByLabel("Triangles").press("Tab");
	await expect(size("glb-low")).not.toHaveText(before);
	await expect(size("glb-low")).toHaveText(/B$/, { timeout: 60_000 });
	await expect(sheet.locator("[data-purpose=game] .size")).toHaveText(await size("glb-low").innerText());
	await expect(sheet.getByRole("group", { name: "Options for GLB, swaying" }).getByLabel("Triangles")).toHaveValue(
		"40000",
	);
	const { bytes } = await studio.downloaded(() => sheet.locator("[data-purpose=game]").click());
	const gltf = JSON.parse(bytes.toString("utf8", 20, 20 + bytes.readUInt32LE(12)));
	const triangles = gltf.meshes
		.flatMap(({ primitives }: { primitives: { indices: number }[] }) => primitives)
		.reduce((sum: number, { indices }: { indices: number }) => sum + gltf.accessors[indices].count / 3, 0);
	expect(triangles).toBeLessThanOrEqual(500);
	await test.step("and are kept while the page is open", async () => {
		const again = await studio.openDownloads();
		await expect(again.getByRole("group", { name: "Options for Low-poly GLB" }).getByLabel("Triangles")).toHaveValue(
			"500",
		);
	});
});

test("the share sheet shows a QR code that opens the plant, and saves it", async ({ page }) => {
	const studio = await new StudioPage(page).open(REDCURRANT);
	const sheet = await studio.openShare();
	const code = sheet.getByRole("img", { name: "QR code of the link" });
	const { width, data } = await studio.pixels(code);
	const link = await sheet.getByRole("textbox", { name: "Link", exact: true }).inputValue();
	expect(decodeQR({ width, height: data.length / 4 / width, data })).toBe(link);
	expect(link).toBe(page.url());
	const save = (ending: string) =>
		studio.downloaded(() => sheet.getByRole("button", { name: `QR code as ${ending}` }).click());
	const svg = await save("SVG");
	expect(svg.name).toBe("redcurrant-altered-5-qr.svg");
	expect(svg.bytes.toString()).toContain(await code.locator("path").getAttribute("d"));
	const png = await save("PNG");
	expect(png.name).toBe("redcurrant-altered-5-qr.png");
	expect(png.bytes.readUInt32BE(16)).toBeGreaterThanOrEqual(1024);
	await expect(sheet.locator(".result:not(:empty)")).toHaveText("Downloaded redcurrant-altered-5-qr.png");
	await page.keyboard.press("Escape");
	await expect(studio.button("Share")).toBeFocused();
});

test("a link that is too long for a QR code is explained, and can still be copied", { tag: "@long" }, async ({
	page,
}) => {
	const rules = Array.from({ length: 400 }, (_, i) => `A${i} --> F(${(i * 7919) % 997}) B${(i * 31) % 400}`);
	const text = await compressText(["axiom: A0", ...rules].join("\n"));
	const studio = await new StudioPage(page).open(`?v=2&model=grammar#g=${text}`);
	const sheet = await studio.openShare();
	await expect(sheet).toContainText(/This link is too long for a QR code: it has [\d,]+ characters, .* hold 1,273\./);
	await expect(sheet.getByRole("img", { name: "QR code of the link" })).toHaveCount(0);
	await expect(sheet.getByRole("button", { name: "Copy link" })).toBeEnabled();
});

test("the system’s share dialog gets the title and the link; without one there is no button", { tag: "@long" }, async ({
	page,
}) => {
	await page.addInitScript(() => {
		const shared: ShareData[] = [];
		Object.assign(window, { shared });
		Object.defineProperty(navigator, "share", {
			configurable: true,
			value: async (data: ShareData) => {
				shared.push(data);
				if (shared.length === 2) throw new DOMException("closed", "AbortError");
				if (shared.length === 3) throw new DOMException("no app", "NotAllowedError");
			},
		});
	});
	const studio = await new StudioPage(page).open("?v=2&preset=riesling&seed=3");
	const sheet = await studio.openShare();
	const button = sheet.getByRole("button", { name: "Share with an app…" });
	const result = sheet.locator(".result:not(:empty)");
	await button.click();
	await expect(result).toHaveText("Shared");
	expect(await page.evaluate(() => (window as unknown as { shared: ShareData[] }).shared)).toEqual([
		{ title: "Riesling", url: page.url() },
	]);
	await button.click();
	await expect(result).toHaveText("Shared");
	await button.click();
	await expect(result).toHaveText("The link was not shared: no app");
	await page.keyboard.press("Escape");
	await page.evaluate(() => Object.defineProperty(navigator, "share", { value: undefined }));
	await expect((await studio.openShare()).getByRole("button", { name: "Share with an app…" })).toHaveCount(0);
});

test.describe("on a phone", () => {
	test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

	test("both sheets are at the bottom of the page, with targets of 44 pixels, and nothing is cut off", {
		tag: "@long",
	}, async ({ page }) => {
		const studio = await new StudioPage(page).open("?v=2&model=flower&preset=tulip");
		for (const open of [() => studio.openDownloads(), () => studio.openShare()]) {
			const sheet = await open();
			const box = await sheet.boundingBox();
			expect(box).toMatchObject({ x: 0, width: 390 });
			expect((box?.y ?? 0) + (box?.height ?? 0)).toBeCloseTo(844, 0);
			expect(await sheet.evaluate((element) => element.scrollWidth - element.clientWidth)).toBe(0);
			for (const control of await sheet.locator("button, label, input:not([type=checkbox])").all()) {
				const { height } = (await control.boundingBox()) ?? { height: 0 };
				expect(height, await control.textContent().then(String)).toBeGreaterThanOrEqual(44);
			}
			await sheet.getByRole("button", { name: "Close" }).click();
			await expect(sheet).toBeHidden();
		}
	});
});

test.describe("to the eye", () => {
	test.use({ drawn: true });

	test("the share sheet downloads the picture, transparent if chosen", { tag: "@long" }, async ({ page }) => {
		const studio = await new StudioPage(page).open("?v=2&preset=redcurrant&seed=5&count=30");
		await studio.stands();
		const sheet = await studio.openShare();
		const save = () => studio.downloaded(() => sheet.getByRole("button", { name: "Download picture" }).click());
		const alphas = (bytes: Buffer) =>
			page.evaluate(async (base64) => {
				const png = Uint8Array.from(atob(base64), (char) => char.charCodeAt(0));
				const image = await createImageBitmap(new Blob([png], { type: "image/png" }));
				const canvas = new OffscreenCanvas(image.width, image.height).getContext("2d");
				canvas?.drawImage(image, 0, 0);
				const { data } = canvas?.getImageData(0, 0, image.width, image.height) ?? new ImageData(1, 1);
				return { corner: data[3], most: Math.max(...data.filter((_, at) => at % 4000 === 3)) };
			}, bytes.toString("base64"));
		const whole = await save();
		expect(whole.name).toBe("redcurrant-altered-5.png");
		expect((await alphas(whole.bytes)).corner).toBe(255);
		await sheet.getByRole("checkbox", { name: "Transparent background" }).check();
		const alone = await save();
		expect(alone.name).toBe("redcurrant-altered-5-cut-out.png");
		expect(await alphas(alone.bytes)).toEqual({ corner: 0, most: 255 });
		await expect(sheet.locator(".result:not(:empty)")).toHaveText("Downloaded redcurrant-altered-5-cut-out.png");
		await expect.poll(() => sheet.locator("canvas.preview").getAttribute("width")).not.toBe("0");
	});
});

test("the result of a button is shown at the button", async ({ page, context }) => {
	await context.grantPermissions(["clipboard-read", "clipboard-write"]);
	await page.setViewportSize({ width: 1280, height: 800 });
	const studio = await new StudioPage(page).open(REDCURRANT);
	await studio.button("Share").click();
	const sheet = page.getByRole("dialog", { name: "Share this plant" });
	/** Presses a button and returns the distance from it to its result, CSS pixels. */
	const distance = async (name: string, result: string) => {
		const button = sheet.getByRole("button", { name });
		await button.click();
		await expect(sheet.locator(".result:not(:empty)")).toHaveText(result);
		const [pressed, shown] = await Promise.all(
			[button, sheet.locator(".result:not(:empty)")].map((each) => each.boundingBox()),
		);
		return shown && pressed ? shown.y - pressed.y - pressed.height : Number.NaN;
	};
	expect(await distance("Copy link", "Link copied")).toBeLessThan(24);
	const download = page.waitForEvent("download");
	expect(await distance("QR code as SVG", "Downloaded redcurrant-altered-5-qr.svg")).toBeLessThan(24);
	await download;
});
