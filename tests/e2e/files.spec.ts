import { readFileSync } from "node:fs";
import { inflateRawSync } from "node:zlib";
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
	await studio.openAdvanced();
	await studio.slider("Berry").focus();
	await studio.regrown(() => page.keyboard.press("Delete"));
	const first = await studio.fingerprint.innerText();
	const { bytes } = await studio.download("glb");
	const { issues } = await validateBytes(new Uint8Array(bytes));
	expect(issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
	// The sheet shows a file's size before it is chosen; simplified files come from a worker with its own wasm.
	const sheet = await studio.openDownloads();
	const sizeOf = (format: string) => sheet.locator(`[data-format=${format}] .size`);
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

test("OBJ with its MTL in one archive", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	const { name, bytes } = await studio.download("obj");
	expect(name).toBe("lychee-1-obj.zip");
	const packed = bytes.readUInt32LE(18);
	const start = 30 + bytes.readUInt16LE(26);
	const obj = inflateRawSync(bytes.subarray(start, start + packed)).toString();
	expect(obj).toContain("mtllib lychee-1.mtl");
	expect(obj.match(/^v /gm)?.length).toBeGreaterThan(1000);
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

	test("the picture leaves out the growth volume that the view shows", async ({ page }) => {
		const studio = await new StudioPage(page).open("?v=2&model=growth&preset=figure-10&steps=3");
		const volume = page.getByRole("button", { name: "Show growth volumes as glass" });
		await expect(volume).toHaveAttribute("aria-pressed", "true");
		const view = page.getByRole("application");
		const withVolume = await studio.pixels(view);
		const first = await studio.download("png");
		await volume.click();
		// More pixels change than those of the button, which is over the view.
		const changed = async () => (await studio.pixels(view)).data.filter((value, at) => value !== withVolume.data[at]);
		await expect.poll(async () => (await changed()).length).toBeGreaterThan(20_000);
		const second = await studio.download("png");
		expect(second.bytes.equals(first.bytes)).toBe(true);
	});
});

test("a file that is none of ours is refused with a word and the bunch stays", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open();
	const first = await studio.fingerprint.innerText();
	await studio.drop("holiday.doc", readFileSync("public/icons/panicle-180.png"));
	await expect(studio.notices).toContainText("holiday.doc has no link to a plant");
	await studio.drop("holiday.txt", Buffer.from("grapes"));
	await expect(studio.notices).toContainText("holiday.txt is neither a GLB nor readable JSON");
	await studio.drop("other.json", Buffer.from('{"specimen": 3}'));
	await expect(studio.notices).toContainText("other.json wasn’t made by Panicle");
	await expect(studio.fingerprint).toHaveText(first);
});
