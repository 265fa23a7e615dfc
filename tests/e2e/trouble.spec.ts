import type { Page } from "@playwright/test";
import { compressText } from "../../web/src/specimen/compressed_text";
import { EditorPage } from "./editor_page";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const alert = (page: Page) => page.getByRole("alert");

test("without the core the page says so, and grows when it comes after all", async ({ page, complaints }) => {
	complaints.expect(/\.wasm|ERR_FAILED/);
	await page.route("**/*.wasm", (route) => route.abort());
	await page.goto("./?v=2");
	await expect(alert(page)).toContainText("Panicle’s core could not be loaded");
	// Scripts that arrive later request the plant again, and would find the core.
	await page.waitForLoadState("networkidle");
	await page.unroute("**/*.wasm");
	await page.getByRole("button", { name: "Try again" }).click();
	await expect(page.locator("[data-fingerprint]")).toHaveText(/^[0-9a-f]{16}$/);
	await expect(alert(page)).toHaveCount(0);
});

test("a core of the wrong MIME type grows all the same", { tag: "@long" }, async ({ page }) => {
	await page.route("**/*.wasm", async (route) => {
		const response = await route.fetch();
		await route.fulfill({ response, headers: { ...response.headers(), "content-type": "application/octet-stream" } });
	});
	const studio = await new StudioPage(page).open();
	await expect(studio.canvas).toHaveAccessibleName(/berries/);
});

test("a page in place of the core is recognised", { tag: "@long" }, async ({ page }) => {
	await page.route("**/*.wasm", (route) => route.fulfill({ contentType: "text/html", body: "<!doctype html>" }));
	await page.goto("./?v=2");
	await expect(alert(page)).toContainText("The server sent something other than Panicle’s core (text/html)");
});

test("a browser without WebAssembly shows what it lacks", { tag: "@long" }, async ({ page }) => {
	await page.addInitScript(() => {
		Reflect.deleteProperty(globalThis, "WebAssembly");
	});
	await page.goto("./?v=2");
	await expect(alert(page)).toContainText("runs no WebAssembly");
});

const withoutWebGL = (page: Page) =>
	page.addInitScript(() => {
		const { getContext } = HTMLCanvasElement.prototype;
		HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
			return kind.startsWith("webgl") ? null : Reflect.apply(getContext, this, [kind, ...rest]);
		} as typeof getContext;
	});

test("without WebGL 2 the page says so and still grows and exports", async ({ page }) => {
	await withoutWebGL(page);
	const studio = await new StudioPage(page).open("?preset=duku");
	await expect(alert(page)).toContainText("WebGL 2");
	await studio.regrown(() => studio.slider("Length").press("PageDown"));
	const { bytes } = await studio.download("glb");
	expect(bytes.toString("latin1", 0, 4)).toBe("glTF");
});

test("without WebGL 2 the button of the grammar opens its text, and what needs the 3-D view has no button", async ({
	page,
}) => {
	await withoutWebGL(page);
	const studio = await new EditorPage(page).open("?v=2&model=grammar");
	await expect(alert(page)).toContainText("WebGL 2");
	await expect(page.getByRole("toolbar", { name: "Tools" }).getByRole("button")).toHaveCount(1);
	await studio.button("Grammar").click();
	await expect(studio.text).toContainText("axiom");
	await expect(studio.button("Grammar")).toHaveAttribute("aria-pressed", "true");
});

type Mode = "through" | "trap" | "silence";

/** Lets a test answer in the worker's place. */
async function wiretap(page: Page, mode: Mode = "through"): Promise<void> {
	await page.addInitScript((first) => {
		const tap = { mode: first, started: 0, ended: 0 };
		Object.assign(globalThis, { tap });
		const { postMessage, terminate } = Worker.prototype;
		Worker.prototype.terminate = function (this: Worker) {
			tap.ended++;
			terminate.call(this);
		};
		Worker.prototype.postMessage = function (this: Worker, ...args: unknown[]) {
			const message = args[0] as { type: string; id: number };
			if (message.type === "start") tap.started++;
			if (message.type === "grow" && tap.mode === "silence") return;
			if (message.type === "grow" && tap.mode === "trap") {
				const data = { type: "trapped", id: message.id, message: "unreachable" };
				queueMicrotask(() => this.dispatchEvent(new MessageEvent("message", { data })));
				return;
			}
			Reflect.apply(postMessage, this, args);
		};
	}, mode);
}

const setMode = (page: Page, mode: Mode) =>
	page.evaluate((next) => {
		(globalThis as unknown as { tap: { mode: string } }).tap.mode = next;
	}, mode);

/** How many workers the page has ended. */
const ended = (page: Page) => page.evaluate(() => (globalThis as unknown as { tap: { ended: number } }).tap.ended);

test("a worker that traps is replaced; the last bunch stays meanwhile", async ({ page }) => {
	await wiretap(page);
	const studio = await new StudioPage(page).open("?preset=short-conical");
	const first = await studio.fingerprint.innerText();
	await setMode(page, "trap");
	await studio.slider("Length").press("PageDown");
	await expect(studio.notices).toContainText("Growing failed unexpectedly");
	await expect(studio.fingerprint).toHaveText(first);
	await setMode(page, "through");
	await studio.regrown(() => studio.slider("Length").press("PageDown"));
	expect(
		await page.evaluate(() => (globalThis as unknown as { tap: { started: number } }).tap.started),
	).toBeGreaterThan(1);
});

test("a long growth says so and can be cancelled, by its button and by Escape", async ({ page }) => {
	await wiretap(page);
	const studio = await new StudioPage(page).open("?preset=short-conical");
	const first = await studio.fingerprint.innerText();
	const growing = page.getByRole("progressbar", { name: "Growing" });
	await setMode(page, "silence");
	for (const cancel of [() => studio.button("Cancel").click(), () => page.keyboard.press("Escape")]) {
		await studio.slider("Length").press("PageDown");
		await expect(growing).toBeVisible();
		await cancel();
		await expect(growing).toBeHidden();
		await expect(studio.notices).toContainText("Growing was cancelled");
		await studio.button("Dismiss").click();
		await expect(studio.fingerprint).toHaveText(first);
	}
	expect(await ended(page)).toBeGreaterThan(1);
	await setMode(page, "through");
	await studio.regrown(() => studio.slider("Length").press("PageDown"));
});

test("what takes long to grow from a text is ended by Escape, which stays in the text, and by the next character", {
	tag: "@long",
}, async ({ page }) => {
	await wiretap(page);
	const studio = await new StudioPage(page).open("?model=grammar&preset=koch-curve-a");
	const first = await studio.fingerprint.innerText();
	const growing = page.getByRole("progressbar", { name: "Growing" });
	await studio.button("Grammar").click();
	const text = page.getByRole("textbox", { name: "Grammar", exact: true });
	await text.press("Control+End");
	await setMode(page, "silence");
	await page.keyboard.type(" ");
	await expect(growing).toBeVisible();
	await page.keyboard.press("Escape");
	await expect(growing).toBeHidden();
	await expect(text).toBeFocused();
	expect(await ended(page)).toBe(1);
	await page.keyboard.type(" ");
	await expect(growing).toBeVisible();
	await setMode(page, "through");
	await page.keyboard.type("F");
	await expect.poll(() => ended(page)).toBeGreaterThan(1);
	await expect(growing).toBeHidden();
	await expect(studio.fingerprint).not.toHaveText(first);
});

test.describe("to the eye", () => {
	test.use({ drawn: true });

	test("a lost context is reported and comes back", { tag: "@long" }, async ({ page, complaints }) => {
		complaints.expect(/CONTEXT_LOST|Context Lost/i);
		const studio = await new StudioPage(page).open();
		await expect.poll(() => studio.inkOnCanvas()).toBeGreaterThan(0.02);
		await studio.canvas.evaluate((canvas: HTMLCanvasElement) => {
			const loss = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context");
			Object.assign(globalThis, { loss });
			loss?.loseContext();
		});
		await expect(alert(page)).toContainText("The graphics card was reset");
		await page.evaluate(() => (globalThis as unknown as { loss: WEBGL_lose_context }).loss.restoreContext());
		await expect(alert(page)).toHaveCount(0);
		await expect.poll(() => studio.inkOnCanvas()).toBeGreaterThan(0.02);
	});
});

test("an error in a grammar is reported with its line and column", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?preset=short-conical");
	const { bytes } = await studio.download("json");
	const first = await studio.fingerprint.innerText();
	const document = JSON.parse(bytes.toString());
	document.specimen.grammar = "axiom: A(\n";
	await studio.drop("broken.json", Buffer.from(JSON.stringify(document)));
	await expect(studio.notices).toContainText(/Line \d+, column \d+ of the grammar/);
	await expect(studio.fingerprint).toHaveText(first);
});

test("a link whose grammar has an error says that there is no bunch, and offers the built-in grammar", async ({
	page,
}) => {
	await page.goto(`./?preset=duku#g=${await compressText("axiom: A(\n")}`);
	await expect(alert(page)).toContainText("The plant can’t be grown with this setting");
	await expect(alert(page)).toContainText(/Line \d+, column \d+ of the grammar/);
	await expect(page.getByRole("application", { name: "Nothing to show yet" })).toBeVisible();
	await expect(page.locator("[data-group=numbers]")).toContainText("Nothing has grown yet.");
	await expect(page.locator("body")).not.toContainText("last plant");
	await alert(page).getByRole("button", { name: "Discard my edits" }).click();
	const studio = new StudioPage(page);
	await expect(studio.canvas).toHaveAccessibleName(/berries/);
	await expect(alert(page)).toHaveCount(0);
	await expect(page).toHaveURL(/\?v=2&preset=duku&procedure=paper$/);
});

test("a trap on the very first growth says that there is no bunch, and grows when asked again", {
	tag: "@long",
}, async ({ page }) => {
	await wiretap(page, "trap");
	await page.goto("./?preset=short-conical");
	await expect(alert(page)).toContainText("Nothing has grown yet.");
	await expect(alert(page).getByRole("button", { name: "Open the default plant" })).toBeVisible();
	await setMode(page, "through");
	await alert(page).getByRole("button", { name: "Try again" }).click();
	await expect(new StudioPage(page).canvas).toHaveAccessibleName(/berries/);
	await expect(alert(page)).toHaveCount(0);
});
