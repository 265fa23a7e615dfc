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

test("a natural bunch's GLB is valid, and brings its age and thinning back", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=pinot-noir&age=90");
	await studio.slider("Berry").focus();
	await studio.regrown(() => page.keyboard.press("Delete"));
	const first = await studio.fingerprint.innerText();
	const { name, bytes } = await studio.download("glb");
	const { issues } = await validateBytes(new Uint8Array(bytes));
	expect(issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
	await studio.regrown(() => page.getByRole("button", { name: "Riesling" }).click());
	await studio.drop(name, bytes);
	await expect(studio.fingerprint).toHaveText(first);
	await expect(page).toHaveURL(/preset=pinot-noir&age=90&thin=/);
});

test("berries as CSV: one line each, in millimetres", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=pinot-noir");
	const { name, bytes } = await studio.download("csv");
	expect(name).toBe("pinot-noir-1-berries.csv");
	const [header, ...lines] = bytes.toString().trimEnd().split("\r\n");
	expect(header.split(",")).toEqual(expect.arrayContaining(["x_mm", "width_mm", "exposure"]));
	expect(lines).toHaveLength(Number(await studio.readout("Berries").innerText()));
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

test("OBJ with its MTL in one archive", async ({ page }) => {
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

	test("the picture is a PNG of the view", async ({ page }) => {
		const studio = await new StudioPage(page).open("?v=2&preset=lychee");
		await expect.poll(() => studio.inkOnCanvas()).toBeGreaterThan(0);
		const { bytes } = await studio.download("png");
		expect(bytes.subarray(1, 4).toString()).toBe("PNG");
		const box = await studio.canvas.boundingBox();
		expect(bytes.readUInt32BE(16)).toBe(2 * Math.round(box?.width ?? 0));
	});
});

test("a file that is none of ours is refused with a word and the bunch stays", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	const first = await studio.fingerprint.innerText();
	await studio.drop("holiday.jpg", readFileSync("public/icons/panicle-180.png"));
	await expect(studio.notices).toContainText("holiday.jpg is neither a GLB nor readable JSON");
	await studio.drop("other.json", Buffer.from('{"specimen": 3}'));
	await expect(studio.notices).toContainText("other.json holds no specimen");
	await expect(studio.fingerprint).toHaveText(first);
});
