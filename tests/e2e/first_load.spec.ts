import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { byKind, firstLoad } from "../bench/sizes.mjs";
import { expectSize } from "../sizes/expect_size";
import { expect, test } from "./fixtures";
import { serveUnder } from "./static_server";
import { StudioPage } from "./studio_page";

test.describe("to the eye", () => {
	test.use({ drawn: true });

	test("the first load shows a bunch, its numbers and its marks", async ({ page }) => {
		const studio = await new StudioPage(page).open();
		await expect(studio.canvas).toHaveAccessibleName(/^Grape bunch: 2[23] cm long, with \d+ berries$/);
		await expect.poll(() => page.evaluate(() => performance.getEntriesByName("first-bunch").length)).toBe(1);
		await expect.poll(() => studio.inkOnCanvas()).toBeGreaterThan(0.02);
		await expect(studio.readout("Rachis segments")).toHaveText("18");
		expect(Number(await studio.readout("Berries").innerText())).toBeGreaterThan(20);
		await expect(page).toHaveTitle("Long conical 1 · Panicle");
		expect(page.url()).toMatch(/\/(\?v=2)?$/);
	});
});

const dist = fileURLToPath(new URL("../../dist", import.meta.url));

test("what packs and writes files is no part of the first load", { tag: "@long" }, async ({ page }) => {
	const scripts = new Set<string>();
	page.on("response", (response) => {
		const { pathname } = new URL(response.url());
		if (pathname.endsWith(".js")) scripts.add(pathname);
	});
	const studio = await new StudioPage(page).open();
	await expect(studio.canvas).toHaveAccessibleName(/berries/);
	// Reads the built files instead of the browser's responses, which it may discard.
	const texts = [...scripts].map((path) => readFileSync(join(dist, path), "utf8"));
	expect(texts.length).toBeGreaterThan(3);
	// The signature of files in a ZIP archive; the test for WebGL proves that scripts were read.
	expect(texts.filter((text) => /67324752|0x4034b50/.test(text))).toEqual([]);
	expect(texts.filter((text) => /webgl2/.test(text))).not.toEqual([]);
});

// The core's own size is a row of tests/sizes/measure.mjs.
for (const { model, tag = "@sizes" } of [
	{ model: "bunch" },
	{ model: "flower" },
	...["leaf", "tree", "root", "grammar", "growth"].map((name) => ({ model: name, tag: ["@sizes", "@long"] })),
]) {
	test(`the first load of a ${model} fetches one core, and is not over 2 % larger than in the last release`, {
		tag,
	}, async ({ page }) => {
		const studio = await new StudioPage(page).open(`?v=2&model=${model}`);
		// Once the plant is drawn, the gallery fetches the presets of every model; each has a picture.
		const presets = readdirSync(join(dist, "gallery"), { recursive: true }).filter((file) =>
			/-light\.webp$/.test(`${file}`),
		);
		const dialog = await studio.browse();
		await dialog.getByRole("button", { name: "All", exact: true }).click();
		await expect(dialog.locator("[data-preset]")).toHaveCount(presets.length);
		await page.keyboard.press("Escape");
		await page.waitForLoadState("networkidle");
		const requested = await page.evaluate(() => {
			const [{ startTime: first }] = performance.getEntriesByName("first-bunch");
			const byPath = new Map<string, boolean>();
			for (const { name, startTime } of performance.getEntriesByType("resource")) {
				const path = new URL(name).pathname.slice(1);
				if (path && !byPath.has(path)) byPath.set(path, startTime > first);
			}
			return [...byPath].map(([path, later]) => ({ path, later }));
		});
		const of = (later: boolean) => requested.filter((each) => each.later === later).map(({ path }) => path);
		const first = firstLoad(dist, ["index.html", ...of(false)]);
		const later = firstLoad(dist, of(true));
		expect(first.filter(({ path }) => path.endsWith(".wasm"))).toHaveLength(1);
		expectSize(`first load of a ${model}: code, gzipped`, byKind(first).code);
		// Of other models only the presets; tools and cores are fetched when they are chosen.
		expect(later.filter(({ path }) => path.endsWith(".wasm"))).toEqual([]);
		expectSize(`after the first load of a ${model}: code, gzipped`, byKind(later).code);
		// They may come before the plant or after it. Pictures are fetched where they come into view: gallery.spec.ts.
		expectSize("fonts of the page", byKind([...first, ...later]).fonts);
	});
}

test("everything that can be worked has a name, and the page its landmarks", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	for (const landmark of ["banner", "main", "complementary", "navigation"] as const) {
		await expect(page.getByRole(landmark)).toHaveCount(1);
	}
	await expect(page.getByRole("region", { name: "Notices" })).toHaveCount(1);
	await studio.openAdvanced();
	const names = ["Length", ...["Right", "Left", "Front", "Back"].flatMap((side) => [`${side} width`, `${side} drop`])];
	for (const name of names) await expect(page.getByRole("slider", { name, exact: true })).toHaveCount(1);
	for (const summary of await page.locator(".group > summary").all()) {
		if (!(await summary.evaluate((element) => (element.parentElement as HTMLDetailsElement).open)))
			await summary.click();
	}
	for (const role of ["button", "slider", "textbox", "combobox", "radio", "radiogroup", "application"] as const) {
		const controls = await page.getByRole(role).count();
		await expect(page.getByRole(role, { name: /\S/ }), `each ${role} has a name`).toHaveCount(controls);
	}
	await expect(studio.canvas).toHaveAccessibleDescription(/Arrow keys rotate/);
	for (const slider of await page.locator("input[type=range]").all()) {
		await expect(slider).toHaveAccessibleDescription(/\S+ … \S+/);
	}
});

test("few stops of the Tab key come before the sliders, and each parameter is two: its slider and its explanation", {
	tag: "@long",
}, async ({ page }) => {
	await new StudioPage(page).open();
	const focused = () =>
		page.evaluate(() => {
			const { activeElement: at } = document;
			const inner = at?.shadowRoot?.activeElement ?? at;
			return `${inner?.tagName.toLowerCase()} ${inner?.closest("[data-key]")?.getAttribute("data-key") ?? ""}`;
		});
	const stops: string[] = [];
	while (stops.length < 60 && stops.at(-1) !== "input count") {
		await page.keyboard.press("Tab");
		stops.push(await focused());
	}
	expect(stops.slice(-4)).toEqual(["summary ", "input l", "button l", "input count"]);
	// The bar has 12, the flat views 7, the 3-D view with its tools 2, the age 2, the presets 3, and the panel 4.
	expect(stops.length, stops.join(", ")).toBeLessThanOrEqual(31);
	await test.step("and the first of all skips those before", async () => {
		expect(stops[0]).toBe("a ");
		const skip = page.getByRole("link", { name: "Skip to the controls" });
		await skip.focus();
		await page.keyboard.press("Enter");
		await page.keyboard.press("Tab");
		await expect(page.locator(".group > summary").first()).toBeFocused();
	});
});

test("nothing sticks out of windows of any size", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open();
	for (const [width, height] of [
		[1440, 900],
		[1024, 640],
		[390, 844],
	]) {
		await page.setViewportSize({ width, height });
		expect(await studio.overflow(), `${width} × ${height}`).toBeLessThanOrEqual(0);
	}
});

test("the app works from a sub-path of any host", async ({ page }) => {
	const server = await serveUnder("/people/botanist/panicle/");
	const foreign: string[] = [];
	page.on("request", (request) => {
		if (!request.url().startsWith(server.address) && !/^(blob|data):/.test(request.url())) foreign.push(request.url());
	});
	await page.goto(`${server.address}?v=2&preset=lychee`);
	await expect(page.getByRole("application", { name: /^Grape bunch: .+ with \d+ berries/ })).toBeVisible();
	await expect(page.locator("[data-preset=lychee]")).toHaveAttribute("aria-current", "true");
	expect(foreign).toEqual([]);
	await page.goto("about:blank");
	await server.close();
});

test("the theme is the system's until it is chosen, and the choice is remembered", async ({ page }) => {
	await page.emulateMedia({ colorScheme: "dark" });
	await new StudioPage(page).open();
	const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
	expect(await paper()).toBe("rgb(20, 16, 14)");
	await page.getByRole("button", { name: "Light theme" }).click();
	expect(await paper()).toBe("rgb(244, 239, 228)");
	await expect(page.locator("meta[name=theme-color][media=all]")).toHaveAttribute("content", "#f4efe4");
	await page.reload();
	await expect(page.getByRole("button", { name: "Dark theme" })).toBeVisible();
	expect(await paper()).toBe("rgb(244, 239, 228)");
});

test("closed groups stay closed", { tag: "@long" }, async ({ page }) => {
	await (await new StudioPage(page).open()).openAdvanced();
	const shape = page.locator("details[data-group=shape]");
	await shape.locator("summary").click();
	await expect(shape).not.toHaveAttribute("open");
	await page.reload();
	await expect(page.locator("details[data-group=numbers]")).toHaveAttribute("open");
	await expect(page.locator("details[data-group=advanced]")).toHaveAttribute("open");
	await expect(shape).not.toHaveAttribute("open");
});
