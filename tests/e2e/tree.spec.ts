import { unzipSync } from "fflate";
import { validateBytes } from "gltf-validator";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** Few enough particles for a machine that draws by software. */
const SMALL = "&n=300";

test("a boundary's point is dragged, stepped by keys and undone; Escape calls a drag off", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open(`?model=tree&preset=oak${SMALL}`);
	await expect(page).toHaveTitle("Oak (edited) 1 · Panicle");
	const grown = await studio.fingerprint.innerText();
	const grip = page.getByRole("region", { name: "Boundary view" }).locator("[data-handle=knot2]");
	const box = await grip.boundingBox();
	if (!box) throw new Error("There is no grip to drag.");
	const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
	const drag = async () => {
		await page.mouse.move(x, y);
		await page.mouse.down();
		for (let step = 1; step <= 6; step++) await page.mouse.move(x - 5 * step, y + step);
	};
	const dragged = await studio.regrown(async () => {
		await drag();
		await page.mouse.up();
	});
	await expect(page).toHaveURL(/profile=/);
	await studio.regrown(() => studio.button("Undo").click());
	await expect(studio.fingerprint).toHaveText(grown);
	await expect(page).not.toHaveURL(/profile=/);

	await drag();
	await expect(studio.fingerprint).not.toHaveText(grown);
	await page.keyboard.press("Escape");
	await page.mouse.up();
	await expect(studio.fingerprint).toHaveText(grown);

	await grip.focus();
	const stepped = await studio.regrown(() => page.keyboard.press("Shift+ArrowLeft"));
	expect(stepped).not.toBe(dragged);
	await expect(grip).toHaveAccessibleName(/^Point 3: [\d.]+ m out, [\d.]+ m up$/);
	await studio.regrown(() => studio.button("Undo").click());
	await expect(studio.fingerprint).toHaveText(grown);

	const trunk = await studio.grip("Boundary", "target0");
	await page.mouse.move(trunk.x, trunk.y);
	await studio.regrown(async () => {
		await page.mouse.down();
		await page.mouse.move(trunk.x + 20, trunk.y + 1, { steps: 3 });
		await page.mouse.up();
	});
	await expect(page).toHaveURL(/targets=[\d.]+,0,0/);
	await studio.openAdvanced();
	await studio.regrown(() => studio.button("Add obstacle").click());
	const wall = page.locator("panicle-plan [data-handle='obstacles0 middle']");
	await wall.focus();
	await studio.regrown(() => page.keyboard.press("Shift+ArrowUp"));
	await expect(wall).toHaveAccessibleName(/^Obstacle 1: [\d.]+ m right, [\d.]+ c?m behind$/);
	expect(page.url().length).toBeLessThan(300);
	for (let steps = 3; steps > 0; steps--) await studio.regrown(() => studio.button("Undo").click());
	await expect(studio.fingerprint).toHaveText(grown);
	await expect(studio.button("Undo")).toBeDisabled();
});

test("trunks and obstacles are taken out by key and by finger, and the focus and the voice follow", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open(`?model=tree&preset=twin${SMALL}`);
	const handle = (id: string) => page.locator(`panicle-boundary [data-handle="${id}"]`);
	await studio.openAdvanced();
	const spoken = page.locator("panicle-boundary [aria-live]");
	await handle("target1").focus();
	await studio.regrown(() => page.keyboard.press("Delete"));
	await expect(handle("target1")).toHaveCount(0);
	await expect(spoken).toHaveText(/^Trunk 2 deleted/);
	await expect(handle("target0")).toBeFocused();
	await expect(handle("target0")).toHaveAccessibleDescription(/^((?!Delete).)*$/);
	await studio.regrown(() => studio.button("Space trunks evenly").click());
	await expect(handle("target1")).toHaveAccessibleDescription(/Delete removes the point, target or obstacle/);
	await expect(studio.button("Space trunks evenly")).toHaveCount(0);

	await studio.regrown(() => studio.button("Add obstacle").click());
	await handle("obstacles0 middle").focus();
	await studio.regrown(() => studio.button("Delete selection").click());
	await expect(handle("obstacles0 middle")).toHaveCount(0);
	await expect(studio.button("Delete selection")).toBeDisabled();
	await studio.regrown(() => studio.button("Undo").click());

	// Undone while it is in hand: it is let go, and comes back by nothing but Redo.
	const { x, y } = await studio.grip("Boundary", "obstacles0 middle");
	const place = (await handle("obstacles0 middle").getAttribute("aria-label")) ?? "";
	await page.mouse.move(x, y);
	await page.mouse.down();
	await page.mouse.move(x + 8, y);
	await expect(handle("obstacles0 middle")).not.toHaveAttribute("aria-label", place);
	await page.keyboard.press("Control+z");
	await expect(handle("obstacles0 middle")).toHaveAttribute("aria-label", place);
	await page.keyboard.press("Control+z");
	await expect(handle("obstacles0 middle")).toHaveCount(0);
	await page.mouse.move(x + 20, y, { steps: 3 });
	await page.mouse.up();
	await expect(handle("obstacles0 middle")).toHaveCount(0);
	await expect(page).not.toHaveURL(/obstacles=/);
});

test("the sun is moved, the age runs back and forth to the same tree", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open(`?model=tree&preset=oak${SMALL}`);
	const grown = await studio.fingerprint.innerText();
	await page.getByRole("region", { name: "Sun view" }).locator("[data-handle=sun]").focus();
	await studio.regrown(() => page.keyboard.press("Shift+ArrowRight"));
	await expect(page).toHaveURL(/sun=55/);
	await studio.regrown(() => studio.button("Undo").click());
	const age = studio.slider("Age");
	await studio.regrown(() => age.press("PageDown"));
	const young = await studio.fingerprint.innerText();
	await studio.regrown(() => age.press("PageUp"));
	await expect(studio.fingerprint).toHaveText(grown);
	await studio.regrown(() => age.press("PageDown"));
	await expect(studio.fingerprint).toHaveText(young);
	await studio.regrown(() => studio.button("Step").click());
	await studio.regrown(() => studio.button("Undo").click());
	await expect(studio.fingerprint).toHaveText(young);
	await page.getByRole("combobox", { name: "Speed" }).selectOption("4 ×");
	await studio.button("Play").click();
	await studio.button("Pause").click();
	await expect(studio.button("Play")).toBeVisible();
});

test("every press of Step is seen, from the scattered particles to the grown tree", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?model=tree&preset=sphere&n=20&leaves=0");
	const grown = await studio.fingerprint.innerText();
	const age = studio.slider("Age");
	await studio.regrown(() => studio.button("Step").click());
	await expect(age).toHaveValue("0");
	let before = await studio.fingerprint.innerText();
	let pressed = 0;
	for (; (await age.inputValue()) !== "100" && pressed < 200; pressed++) {
		await studio.regrown(() => studio.button("Step").click());
		const now = await studio.fingerprint.innerText();
		expect(now).not.toBe(before);
		before = now;
	}
	expect(before).toBe(grown);
	expect(pressed).toBeGreaterThan(5);
	expect(pressed).toBeLessThan(200);
});

test("a tree is downloaded as GLB, OBJ and JSON", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?model=tree&preset=sphere&n=60");
	const glb = await studio.download("glb");
	const { issues } = await validateBytes(new Uint8Array(glb.bytes));
	expect([issues.numErrors, issues.numWarnings]).toEqual([0, 0]);
	const obj = unzipSync(new Uint8Array((await studio.download("obj")).bytes));
	expect(Object.keys(obj).some((name) => name.endsWith(".obj"))).toBe(true);
	const json = JSON.parse((await studio.download("json")).bytes.toString());
	expect(json.specimen).toMatchObject({ model: "tree", preset: "sphere" });
	expect(json.targets).toHaveLength(1);
	expect(json.fingerprint).toBe(await studio.fingerprint.innerText());
});

test("a closed mesh dropped on the boundary becomes it, and the page says where it is kept", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open(`?model=tree&preset=box${SMALL}`);
	const octahedron = ["1 0 0", "-1 0 0", "0 1 0", "0 -1 0", "0 0 1", "0 0 -1"].map((point) => `v ${point}`);
	const faces = ["1 3 5", "3 2 5", "2 4 5", "4 1 5", "3 1 6", "2 3 6", "4 2 6", "1 4 6"].map((face) => `f ${face}`);
	const drop = (name: string, text: string) =>
		page.locator("panicle-boundary").evaluate(
			(view, [fileName, content]) => {
				const dataTransfer = new DataTransfer();
				dataTransfer.items.add(new File([content], fileName));
				const init = { dataTransfer, bubbles: true, cancelable: true, composed: true };
				for (const type of ["dragover", "drop"]) view.dispatchEvent(new DragEvent(type, init));
			},
			[name, text],
		);
	await studio.regrown(() => drop("octahedron.obj", [...octahedron, ...faces].join("\n")));
	await expect(studio.notices).toContainText("The mesh is now the boundary");
	await expect(page.locator(".override").filter({ hasText: "A mesh of 8 triangles." })).toHaveCount(1);
	await expect(page.locator("panicle-boundary path.outer")).toHaveAttribute("d", /^M[^L]+(L[^L]+){3}Z$/);
	await expect(studio.notices).not.toContainText("The file was not opened");
	const inSpace = studio.button("Boundary in 3D");
	await inSpace.click();
	await expect(inSpace).toHaveAttribute("aria-pressed", "true");
	// A mesh of one's own is the inner boundary, too.
	const mesh = { name: "inner.obj", mimeType: "model/obj", buffer: Buffer.from([...octahedron, ...faces].join("\n")) };
	await studio.openAdvanced();
	await page.getByLabel(/^Choose inner mesh/).setInputFiles(mesh);
	await expect(studio.notices).toContainText("The mesh is now the inner boundary");
	await expect(page.locator("panicle-boundary path.inner")).toHaveAttribute("d", /^M[^L]+(L[^L]+){3}Z$/);
	await studio.button("Remove inner mesh").click();
	await expect(studio.button("Remove inner mesh")).toHaveCount(0);
	const light = studio.button("Light in the crown");
	await light.click();
	await expect(light).toHaveAttribute("aria-pressed", "true");
	await expect(page.getByRole("group", { name: "Light in the crown" })).toContainText("Dark, dense cells: shade.");
	await drop("broken.obj", "v 0 0 0\nf 1 2 3\n");
	await expect(studio.notices).toContainText("Line 2 of the OBJ: “2” does not refer to a point above this line.");
});

test("roots stand below ground, and another model's preset brings its views", async ({ page }) => {
	const studio = await new StudioPage(page).open("?model=root&n=300");
	await expect(page).toHaveTitle("Tap root (edited) 1 · Panicle");
	await expect(page.getByRole("application", { name: /^Root: [\d.]+ m deep, [\d,]+ root tips/ })).toBeVisible();
	await expect(page.getByRole("region", { name: "Sun view" })).toHaveCount(0);
	await studio.regrown(() => studio.choosePreset("tree", "cypress"));
	await expect(page.getByRole("region", { name: "Sun view" })).toBeVisible();
	await studio.regrown(() => studio.button("Undo").click());
	await expect(page.getByRole("region", { name: "Sun view" })).toHaveCount(0);
});
