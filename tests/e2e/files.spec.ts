import { readFileSync } from "node:fs";
import { inflateRawSync } from "node:zlib";
import { strFromU8, unzipSync } from "fflate";
import { validateBytes } from "gltf-validator";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("GLB: valid, and dropped back it restores its bunch", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical&seed=7&l=260&procedure=paper");
	const first = await studio.fingerprint.innerText();
	for (const format of ["glb", "glb-instanced"]) {
		const { name, bytes } = await studio.download(format);
		expect(name).toMatch(/^short-conical-altered-7.*\.glb$/);
		const { issues } = await validateBytes(new Uint8Array(bytes));
		expect(issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
		await studio.regrown(() => page.getByRole("button", { name: "Lychee" }).click());
		await studio.drop(name, bytes);
		await expect(studio.fingerprint).toHaveText(first);
		await expect(page).toHaveURL(/preset=short-conical&seed=7&l=260/);
	}
});

test("a natural bunch's GLB is valid, and brings its age and thinning back", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=pinot-noir&age=90");
	await studio.slider("Berry").focus();
	await studio.regrown(() => page.keyboard.press("Delete"));
	const first = await studio.fingerprint.innerText();
	const { bytes } = await studio.download("glb");
	const { issues } = await validateBytes(new Uint8Array(bytes));
	expect(issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
	// The menu shows a file's size before it is chosen; simplified files come from a worker with its own wasm.
	await studio.button("Download").click();
	const sizeOf = (format: string) => page.locator(`[data-format=${format}] .size`);
	for (const format of ["glb", "glb-web", "glb-low"])
		await expect(sizeOf(format)).toHaveText(/^[\d.]+ (k|M)B$/, { timeout: 60_000 });
	const web = await sizeOf("glb-web").innerText();
	await page.keyboard.press("Escape");
	const light = await studio.download("glb-web");
	expect(light.name).toMatch(/^pinot-noir-altered-1-web\.glb$/);
	expect(light.bytes.length).toBeLessThan(0.4 * bytes.length);
	expect(web).toBe(`${Math.round(light.bytes.length / 1000)} kB`);
	await studio.regrown(() => page.getByRole("button", { name: "Riesling" }).click());
	await studio.drop(light.name, light.bytes);
	await expect(studio.fingerprint).toHaveText(first);
	await expect(page).toHaveURL(/preset=pinot-noir&age=90&thin=/);
});

test("berries as CSV: one line each, in millimetres", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=pinot-noir");
	const { name, bytes } = await studio.download("csv");
	expect(name).toBe("pinot-noir-1-berries.csv");
	const [header, ...lines] = bytes.toString().trimEnd().split("\r\n");
	expect(header.split(",")).toEqual(expect.arrayContaining(["x_mm", "width_mm", "exposure"]));
	expect(lines).toHaveLength(Number(await studio.readout("Berries").innerText()));
	const measures = await studio.download("csv-measures");
	expect(measures.name).toBe("pinot-noir-1-measures.csv");
	expect(measures.bytes.toString()).toContain(`,berry_count,Berries,${lines.length},`);
});

test("JSON: the numbers of the page, and it restores its bunch from the picker", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=rubus");
	const first = await studio.fingerprint.innerText();
	const { name, bytes } = await studio.download("json");
	const document = JSON.parse(bytes.toString());
	expect(document.fingerprint).toBe(first);
	expect(String(document.counts.berries)).toBe(await studio.readout("Berries").innerText());
	await studio.regrown(() => studio.button("New variation").click());
	const choosing = page.waitForEvent("filechooser");
	await studio.button("Open…").click();
	await (await choosing).setFiles({ name, mimeType: "application/json", buffer: bytes });
	await expect(studio.fingerprint).toHaveText(first);
});

test("OBJ with its MTL in one archive, and a series of plants in one", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	const { name, bytes } = await studio.download("obj");
	expect(name).toBe("lychee-1-obj.zip");
	const packed = bytes.readUInt32LE(18);
	const start = 30 + bytes.readUInt16LE(26);
	const obj = inflateRawSync(bytes.subarray(start, start + packed)).toString();
	expect(obj).toContain("mtllib lychee-1.mtl");
	expect(obj.match(/^v /gm)?.length).toBeGreaterThan(1000);

	// Batch export: invalid input is reported at its field, a long series is cancelled, a short one gives one archive.
	await studio.button("Download").click();
	await page.locator("[data-format=many]").click();
	const dialog = page.getByRole("dialog", { name: "Many in one ZIP" });
	const grow = async (numbers: string, vary: string) => {
		await dialog.getByLabel("Plants").fill(numbers);
		await dialog.getByLabel("Vary").fill(vary);
		await dialog.getByRole("button", { name: "Grow them" }).click();
	};
	await dialog.getByLabel("Files").selectOption("JSON");
	await grow("1-2", "age=60..900");
	await expect(dialog.getByRole("alert")).toHaveText("age: 900 is above the greatest value, 125.");
	await grow("1-1000", "age=60..110");
	await expect(dialog.getByRole("progressbar", { name: "Growing the series" })).toBeVisible();
	await expect(dialog.getByRole("status")).toContainText(/[1-9]\d* of 1000/);
	await dialog.getByRole("button", { name: /^Cancel/ }).click();
	await expect(dialog.getByRole("progressbar")).toHaveCount(0);
	await expect(dialog.getByRole("alert")).toHaveCount(0);
	const downloading = page.waitForEvent("download");
	await grow("1-2", "age=60..110");
	const download = await downloading;
	expect(download.suggestedFilename()).toBe("lychee-1-2.zip");
	const files = unzipSync(new Uint8Array(readFileSync(await download.path())));
	expect(Object.keys(files)).toEqual(["lychee-1.json", "lychee-2.json", "plants.csv", "series.json"]);
	const [header, first] = strFromU8(files["plants.csv"]).split("\r\n");
	expect(header).toMatch(/^number,seed,file,bytes,crc32,fingerprint,link,set_age,/);
	expect(first).toContain(JSON.parse(strFromU8(files["lychee-1.json"])).fingerprint);
	await expect(dialog).toBeHidden();
});

test.describe("to the eye", () => {
	test.use({ drawn: true });

	test("the picture is a PNG of the view", { tag: "@long" }, async ({ page }) => {
		const studio = await new StudioPage(page).open("?v=2&preset=lychee");
		await expect.poll(() => studio.inkOnCanvas()).toBeGreaterThan(0);
		const { bytes } = await studio.download("png");
		expect(bytes.subarray(1, 4).toString()).toBe("PNG");
		const box = await studio.canvas.boundingBox();
		expect(bytes.readUInt32BE(16)).toBe(2 * Math.round(box?.width ?? 0));
		// It carries its link, and opens again when it is dropped; the front view's photograph it does not become.
		const first = await studio.fingerprint.innerText();
		await studio.regrown(() => studio.button("New variation").click());
		await studio.drop("lychee.png", bytes);
		await expect(studio.fingerprint).toHaveText(first);
	});
});

test("a file that is none of ours is refused with a word and the bunch stays", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open();
	const first = await studio.fingerprint.innerText();
	await studio.drop("holiday.doc", readFileSync("public/icons/panicle-180.png"));
	await expect(studio.notices).toContainText("holiday.doc is a picture without a link");
	await studio.drop("holiday.txt", Buffer.from("grapes"));
	await expect(studio.notices).toContainText("holiday.txt is neither a GLB nor readable JSON");
	await studio.drop("other.json", Buffer.from('{"specimen": 3}'));
	await expect(studio.notices).toContainText("other.json holds no specimen");
	await expect(studio.fingerprint).toHaveText(first);
});
