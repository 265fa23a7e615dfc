import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

async function dragBy(studio: StudioPage, handle: string, dx: number, dy: number): Promise<void> {
	const { mouse } = studio.page;
	const { x, y } = await studio.grip("Front", handle);
	await mouse.move(x, y);
	await mouse.down();
	await mouse.move(x + dx / 2, y + dy / 2, { steps: 4 });
	await mouse.move(x + dx, y + dy, { steps: 4 });
	await mouse.up();
}

const value = (page: Page, name: string) => page.getByRole("slider", { name, exact: true }).inputValue();

test("dragging a handle regrows the bunch and is one step, in the address and in the history", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const first = await studio.fingerprint.innerText();
	await studio.regrown(() => dragBy(studio, "p3", 30, 10));
	await expect(page).toHaveURL(/[?&]p3=\d+,\d+/);
	await studio.openAdvanced();
	expect(Number(await value(page, "Right width"))).toBeGreaterThan(60);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(first);
	await expect(page).not.toHaveURL(/p3=/);
	await expect(studio.button("Undo")).toBeDisabled();
	await studio.button("Redo").click();
	await expect(studio.fingerprint).not.toHaveText(first);
	await expect(page).toHaveURL(/[?&]p3=\d+,\d+/);
});

test("a handle stays below the pointer that lets go of it, and the view suits the bunch once it leaves", {
	tag: "@long",
}, async ({ page }) => {
	await page.clock.install();
	const studio = await new StudioPage(page).open("?v=2&preset=long-conical");
	const view = page.getByRole("region", { name: "Front view" });
	const { x, y } = await studio.grip("Front", "p2");
	const field = await view.locator("panicle-profile").boundingBox();
	if (!field) throw new Error("no view");
	const to = field.y + 0.25 * field.height;
	await page.mouse.move(x, y);
	await page.mouse.down();
	await studio.regrown(() => page.mouse.move(x, to, { steps: 6 }));
	await page.mouse.up();
	// Longer than the view waits before it fits a bunch that no longer changes.
	await page.clock.runFor(1000);
	const at = async () => {
		const box = await studio.handle("Front", "p2").boundingBox();
		return box ? box.y + box.height / 2 : Number.NaN;
	};
	expect(Math.abs((await at()) - to)).toBeLessThan(4);
	await page.mouse.move(field.x + field.width + 200, to);
	await expect.poll(at).toBeGreaterThan(to + 8);
});

test("presses of an arrow key that follow each other are one step", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const first = await studio.fingerprint.innerText();
	await studio.handle("Front", "p3").focus();
	for (let press = 0; press < 3; press++) await studio.regrown(() => page.keyboard.press("ArrowRight"));
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(first);
	await expect(studio.button("Undo")).toBeDisabled();
});

test("a pen drags a handle, and that is one undo step", { tag: "@long" }, async ({ page, context }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const { x, y } = await studio.grip("Front", "p4");
	const seen = page.evaluate(
		() =>
			new Promise((resolve) => addEventListener("pointerdown", (event) => resolve(event.pointerType), { once: true })),
	);
	const session = await context.newCDPSession(page);
	const pen = (type: "mousePressed" | "mouseMoved" | "mouseReleased", dx: number) => {
		const held = { button: "left", buttons: type === "mouseReleased" ? 0 : 1, clickCount: 1 } as const;
		return session.send("Input.dispatchMouseEvent", { type, x: x - dx, y, pointerType: "pen", ...held });
	};
	await studio.regrown(async () => {
		await pen("mousePressed", 0);
		for (const dx of [8, 16, 24]) await pen("mouseMoved", dx);
		await pen("mouseReleased", 24);
	});
	expect(await seen).toBe("pen");
	await expect(page).toHaveURL(/p4=/);
	await studio.button("Undo").click();
	await expect(studio.button("Undo")).toBeDisabled();
});

test("a drag that ends where it began leaves no step and keeps what can be redone", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	await studio.regrown(() => studio.button("New variation").click());
	await studio.regrown(() => studio.button("Undo").click());
	const first = await studio.fingerprint.innerText();
	const { x, y } = await studio.grip("Front", "p3");
	await page.mouse.move(x, y);
	await page.mouse.down();
	await studio.regrown(() => page.mouse.move(x + 30, y, { steps: 3 }));
	await expect(studio.button("Redo")).toBeDisabled();
	await page.mouse.move(x, y, { steps: 3 });
	await page.mouse.up();
	await expect(studio.fingerprint).toHaveText(first);
	await expect(studio.button("Undo")).toBeDisabled();
	await expect(studio.button("Redo")).toBeEnabled();
});

test("the tip's handle makes the bunch longer under the mouse, before it is let go", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical&l=300");
	const { x, y } = await studio.grip("Front", "p2");
	await page.mouse.move(x, y);
	await page.mouse.down();
	await studio.regrown(() => page.mouse.move(x, y + 25, { steps: 3 }));
	expect(Number(await value(page, "Length"))).toBeGreaterThan(320);
	await expect(page).toHaveURL(/l=300/);
	await page.mouse.up();
	await expect(page).not.toHaveURL(/l=300/);
});

test("sliders work by keyboard, say their unit, and a held key is one step", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const slider = studio.slider("Length");
	await expect(slider).toHaveAttribute("aria-valuetext", "225.4 millimetres");
	await slider.focus();
	await page.keyboard.down("ArrowLeft");
	for (let repeat = 0; repeat < 5; repeat++) await page.keyboard.down("ArrowLeft");
	await page.keyboard.up("ArrowLeft");
	await expect(slider).toHaveValue("517");
	await expect(page).toHaveURL(/l=517/);
	await page.keyboard.press("Control+z");
	await expect(slider).toHaveValue("523");
	await page.keyboard.press("Control+Shift+Z");
	await expect(slider).toHaveValue("517");
	await page.keyboard.press("Control+z");
	await page.keyboard.press("Control+y");
	await expect(slider).toHaveValue("517");
	await page.keyboard.press("Delete");
	await expect(slider).toHaveValue("523");
});

test("typed values are taken, clamped with a word, or refused with one", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	const field = page.getByRole("textbox", { name: "Length in millimetres", exact: true });
	await field.fill("150");
	await field.press("Enter");
	await expect(studio.slider("Length")).toHaveValue("348");
	await expect(studio.slider("Length")).toHaveAttribute("aria-valuetext", "150 millimetres");
	await studio.openAdvanced();
	await page.getByRole("switch", { name: "Also show lengths in pixels, as in Huang et al. (2013)" }).check();
	await expect(page.locator("[data-key=l] label")).toContainText("348 px");
	await field.fill("900");
	await field.press("Enter");
	await expect(field).toHaveValue("250");
	await expect(page.getByText("Length: 900 was changed to 250.")).toBeVisible();
	await field.fill("wide");
	await field.press("Enter");
	await expect(field).toHaveValue("250");
	await expect(page.getByText("“wide” is not a number. Length is still 250.")).toBeVisible();
});

test("a double click on a slider's name brings the preset's value back", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical&l=300");
	await page.locator("label", { hasText: "Length" }).first().dblclick();
	await expect(studio.slider("Length")).toHaveValue("523");
});

test("a double click on a handle brings its numbers back, as one step", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical&p3=90,150&l=400");
	await studio.openAdvanced();
	const { x, y } = await studio.grip("Front", "p3");
	await studio.regrown(() => page.mouse.dblclick(x, y));
	await expect(studio.slider("Right width")).toHaveValue("47");
	await expect(studio.slider("Length")).toHaveValue("400");
	await expect(page).not.toHaveURL(/p3=/);
	await studio.button("Undo").click();
	await expect(studio.slider("Right width")).toHaveValue("90");
	await expect(studio.button("Undo")).toBeDisabled();
});

test("mirror, locks and reset", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=short-conical");
	const first = await studio.fingerprint.innerText();
	await studio.openAdvanced();
	await studio.regrown(() => studio.button("Mirror left–right").click());
	expect([await value(page, "Right width"), await value(page, "Left width")]).toEqual(["116", "79"]);
	await studio.regrown(() => studio.button("Mirror front–back").click());
	expect([await value(page, "Front width"), await value(page, "Back width")]).toEqual(["97", "101"]);
	expect([await value(page, "Front drop"), await value(page, "Back drop")]).toEqual(["103", "112"]);
	await studio.button("Lock left–right").click();
	await expect(studio.slider("Left width")).toHaveValue("116");
	await studio.slider("Left width").press("ArrowRight");
	await expect(studio.slider("Right width")).toHaveValue("117");
	await studio.button("Lock front–back").click();
	await expect(studio.slider("Back drop")).toHaveValue("103");
	await studio.button("Reset").click();
	await expect(studio.fingerprint).toHaveText(first);
	await expect(studio.button("Reset")).toBeDisabled();
});

test("a new variation is another bunch of the same shape; typing its seed brings one back", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open();
	const first = await studio.fingerprint.innerText();
	await studio.regrown(() => studio.button("New variation").click());
	await expect(studio.readout("Rachis segments")).toHaveText("18");
	const seed = page.getByRole("textbox", { name: "Seed", exact: true });
	await seed.fill("1");
	await seed.press("Enter");
	await expect(studio.fingerprint).toHaveText(first);
	await seed.fill("5000000000");
	await seed.press("Enter");
	await expect(seed).toHaveValue("4294967295");
	await expect(studio.notices).toContainText("4,294,967,295 was used");
});

test("as printed sets fit and vary to 0 and back", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&procedure=paper");
	await studio.openGroup("Fine fit");
	const first = await studio.fingerprint.innerText();
	await studio.regrown(() => page.getByRole("switch", { name: "As printed" }).click());
	await expect(studio.slider("Fine fit")).toHaveValue("0");
	await expect(studio.slider("Variation")).toHaveValue("0");
	await page.getByRole("switch", { name: "As printed" }).click();
	await expect(studio.fingerprint).toHaveText(first);
});

test("colours change the picture, not the bunch", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open();
	const first = await studio.fingerprint.innerText();
	const skin = page.getByRole("textbox", { name: "Skin colour, six hexadecimal digits" });
	await skin.fill("#88AA44");
	await skin.press("Enter");
	await expect(page).toHaveURL(/skin=88aa44/);
	await expect(studio.fingerprint).toHaveText(first);
	await skin.fill("green");
	await skin.press("Enter");
	await expect(skin).toHaveValue("88aa44");
	await expect(studio.notices).toContainText("six hexadecimal digits");
});

test("a flat view draws the bunch that stands there, in the theme's ink", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=cylindrical");
	const drawing = page.getByRole("region", { name: "Front view" }).locator("canvas");
	/** Centre of the drawing in shares of the view, and mean brightness of the ink. */
	const ink = () =>
		drawing.evaluate((canvas: HTMLCanvasElement) => {
			const { width, height } = canvas;
			const { data } = canvas.getContext("2d")?.getImageData(0, 0, width, height) ?? { data: [] };
			const sum = { x: 0, light: 0, count: 0 };
			for (let at = 0; at < data.length; at += 4) {
				if (data[at + 3] < 128) continue;
				sum.count += 1;
				sum.x += ((at / 4) % width) / width;
				sum.light += (data[at] + data[at + 1] + data[at + 2]) / 3;
			}
			return { count: sum.count, x: sum.x / sum.count, light: sum.light / sum.count };
		});
	const first = await ink();
	expect(first.count).toBeGreaterThan(300);
	expect(first.x).toBeCloseTo(0.5, 1);
	expect(first.light).toBeLessThan(90);
	await studio.openAdvanced();
	await studio.regrown(() => studio.slider("Right width").fill("150"));
	await expect.poll(async () => (await ink()).x).toBeGreaterThan(first.x + 0.01);
	await studio.button("Dark theme").click();
	await expect.poll(async () => (await ink()).light).toBeGreaterThan(165);
});
