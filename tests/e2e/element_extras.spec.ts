import type { Locator, Page } from "@playwright/test";
import type { PanicleSpecimen } from "../../web/src/element/panicle";
import { byKind, firstLoad } from "../bench/sizes.mjs";
import { expectSize } from "../sizes/expect_size";
import { grown, openHost, SMALL, serveLibrary } from "./element_page";
import { expect, test } from "./fixtures";

let library: Awaited<ReturnType<typeof serveLibrary>>;
test.beforeAll(async () => {
	library = await serveLibrary();
});
test.afterAll(() => library.close());
const open = (page: Page, body: string) => openHost(page, library.address, body);

/** Events of the plant from now on. */
async function listen(page: Page): Promise<() => Promise<[string, string][]>> {
	await page.evaluate(() => {
		const heard: [string, string][] = [];
		Object.assign(window, { heard });
		const plant = document.querySelector("panicle-specimen") as PanicleSpecimen;
		for (const type of ["input", "change", "grown"])
			plant.addEventListener(type, (event) =>
				heard.push([type, (event as CustomEvent<{ link: string }>).detail?.link]),
			);
	});
	return () => page.evaluate(() => (window as unknown as { heard: [string, string][] }).heard);
}

async function middle(of: Locator): Promise<{ x: number; y: number }> {
	const box = await of.boundingBox();
	if (!box) throw new Error("It is not on the page.");
	return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

test("the bar turns, ages, seeds and saves a plant, and leads into the app", async ({ page }) => {
	const close = await open(page, `<panicle-specimen ${SMALL} controls></panicle-specimen>`);
	await grown(page);
	const bar = page.getByRole("group", { name: "Controls" });
	await expect(bar).toBeVisible();
	const heard = await listen(page);
	const age = bar.getByRole("slider", { name: "Age" });
	await expect(age).toHaveValue("100");
	// By keys alone: from the view, the bar's controls are the next stops.
	await page.getByRole("application").focus();
	await page.keyboard.press("Tab");
	await expect(bar.getByRole("button", { name: "Turn" })).toBeFocused();
	await page.keyboard.press("Tab");
	await expect(age).toBeFocused();
	await page.keyboard.press("Home");
	const aged = "?v=2&preset=redcurrant&count=6&age=0";
	await expect.poll(heard).toContainEqual(["grown", aged]);
	expect((await heard()).slice(0, 2)).toEqual([
		["input", aged],
		["change", aged],
	]);
	await expect(page.getByRole("application", { name: /^Redcurrant bunch: .+ with \d+ flowers/ })).toBeVisible();
	await expect(bar.getByRole("status")).toHaveText(/^Redcurrant bunch: .+ with \d+ flowers/);
	const seed = bar.getByRole("spinbutton", { name: "Seed" });
	await seed.fill("12");
	await seed.press("Enter");
	const seeded = "?v=2&preset=redcurrant&seed=12&count=6&age=0";
	await expect.poll(heard).toContainEqual(["change", seeded]);
	await seed.fill("-1");
	await seed.press("Enter");
	await expect(seed).toHaveValue("12");
	// An invalid seed gives back the last valid one, also while that one's plant still grows.
	const typed = await seed.evaluate((field: HTMLInputElement) => {
		for (const value of ["14", "-1"]) {
			field.value = value;
			field.dispatchEvent(new Event("change"));
		}
		return field.value;
	});
	expect(typed).toBe("14");
	await seed.fill("12");
	await seed.press("Enter");
	await expect(bar.getByRole("link", { name: "Open in the app" })).toHaveAttribute("href", /seed=12/);
	await expect(bar.getByRole("link", { name: "Open in the app" })).toHaveAttribute(
		"href",
		`${library.address}${seeded}`,
	);
	const downloading = page.waitForEvent("download");
	await bar.getByRole("button", { name: "Download GLB" }).click();
	expect((await downloading).suggestedFilename()).toBe("redcurrant-12.glb");
	// Errors are visible and announced until a plant grows.
	await page.evaluate(() => {
		const plant = document.querySelector("panicle-specimen") as PanicleSpecimen;
		plant.toFile = () => Promise.reject(new Error("no room is left"));
	});
	await bar.getByRole("button", { name: "Download GLB" }).click();
	const error = bar.getByText("The GLB could not be made: no room is left");
	expect((await error.boundingBox())?.height).toBeGreaterThan(10);
	await seed.fill("13");
	await seed.press("Enter");
	await expect(error).toHaveCount(0);
	const turn = bar.getByRole("button", { name: "Turn" });
	await turn.click();
	await expect(turn).toHaveAttribute("aria-pressed", "true");
	await expect(page.locator("panicle-specimen")).toHaveAttribute("autorotate", "");
	const plant = page.locator("panicle-specimen");
	await plant.evaluate((element) => element.setAttribute("autorotate", "30"));
	await turn.click();
	await expect(plant).not.toHaveAttribute("autorotate");
	await turn.click();
	await expect(plant).toHaveAttribute("autorotate", "30");
	// Where less motion is wished for it turns a step a press.
	await page.emulateMedia({ reducedMotion: "reduce" });
	await turn.click();
	await expect(turn).not.toHaveAttribute("aria-pressed");
	await page.evaluate(() => document.querySelector("panicle-specimen")?.removeAttribute("controls"));
	await expect(bar).toHaveCount(0);
	await close();
});

test("handles stand on the plant, follow hand and keys, and the plant regrows", { tag: "@sizes" }, async ({ page }) => {
	const scripts: string[] = [];
	page.on("request", (request) => {
		if (request.url().endsWith(".js")) scripts.push(request.url().slice(library.address.length));
	});
	const close = await open(page, `<panicle-specimen ${SMALL}></panicle-specimen>`);
	await grown(page);
	expect(scripts.filter((url) => /handles_layer|plant_handles|bar-/.test(url))).toEqual([]);
	await page.evaluate(() => document.querySelector("panicle-specimen")?.setAttribute("handles", ""));
	const right = page.getByRole("button", { name: /^Right: / });
	await expect(right).toBeVisible();
	const heard = await listen(page);
	const widthOf = async () => Number(/Right: ([\d.]+) mm/.exec((await right.getAttribute("aria-label")) ?? "")?.[1]);
	const before = await widthOf();
	const from = await middle(right);
	await page.mouse.move(from.x, from.y);
	await page.mouse.down();
	await page.mouse.move(from.x + 30, from.y, { steps: 4 });
	await expect.poll(async () => (await heard()).filter(([type]) => type === "grown").length).toBeGreaterThan(0);
	expect((await heard()).some(([type]) => type === "change")).toBe(false);
	// It stays under the pointer.
	await expect.poll(async () => Math.abs((await middle(right)).x - from.x - 30)).toBeLessThan(3);
	await page.mouse.up();
	await expect.poll(async () => (await heard()).map(([type]) => type)).toContain("change");
	expect(await widthOf()).toBeGreaterThan(before + 1);
	const [, link] = (await heard()).find(([type]) => type === "change") ?? [];
	expect(link).toMatch(/^\?v=2&preset=redcurrant&p3=[\d.]+,[\d.]+&count=6$/);
	// Escape calls a drag off.
	const dragged = await widthOf();
	const there = await middle(right);
	await page.mouse.move(there.x, there.y);
	await page.mouse.down();
	await page.mouse.move(there.x - 20, there.y, { steps: 3 });
	await expect.poll(widthOf).not.toBe(dragged);
	await page.keyboard.press("Escape");
	await expect.poll(widthOf).toBe(dragged);
	await page.mouse.up();
	// Keys: the next handle, and a step of it.
	await right.focus();
	await page.keyboard.press("PageDown");
	const left = page.getByRole("button", { name: /^Left: / });
	await expect(left).toBeFocused();
	const held = await left.getAttribute("aria-label");
	await page.keyboard.press("Shift+ArrowUp");
	await expect(left).not.toHaveAttribute("aria-label", held ?? "");
	await expect(page.getByRole("group", { name: "Handles" }).getByRole("status")).toHaveText(
		/mm wide, [\d.]+ mm below the top$/,
	);
	expectSize("element with handles: scripts, gzipped", byKind(firstLoad("dist", [...new Set(scripts)])).code);
	// They go with the plant when that is turned.
	const front = page.getByRole("button", { name: /^Front: / });
	const at = await middle(front);
	for (let i = 0; i < 4; i++) await page.getByRole("application").press("ArrowLeft");
	await expect.poll(async () => Math.abs((await middle(front)).x - at.x)).toBeGreaterThan(3);
	await close();
});

test("every model is described, shows its age where it has one, and has handles", {
	tag: ["@sizes", "@long"],
}, async ({ page }) => {
	const scripts = new Set<string>();
	page.on("request", (request) => {
		if (request.url().endsWith(".js")) scripts.add(request.url().slice(library.address.length));
	});
	const plants = [
		["", /^Long conical bunch: \d+ cm long, with \d+ berries$/],
		['preset="grape-15a" procedure="paper"', /^Grape \(a\) bunch: .+, with \d+ berries/],
		['model="leaf" preset="birch"', /^Birch leaf, [\d.]+ cm²/],
		['model="tree" preset="box" particles="400"', /tree: [\d.]+ m tall/],
		['model="root" preset="carrot"', /root: \d+ cm deep/],
	] as const;
	const tags = plants.map(
		([of]) => `<panicle-specimen ${of} controls handles style="width: 200px; height: 240px"></panicle-specimen>`,
	);
	const close = await open(page, tags.join(""));
	await grown(page);
	for (const [i, [, words]] of plants.entries()) {
		const plant = page.locator("panicle-specimen").nth(i);
		await expect(plant.getByRole("application")).toHaveAccessibleName(words);
		await expect(plant.getByRole("group", { name: "Handles" }).getByRole("button").first()).toBeVisible();
		await expect(plant.getByRole("slider", { name: "Age" })).toHaveCount(i === 1 ? 0 : 1);
		for (const control of await plant.getByRole("button").all()) await expect(control).toHaveAccessibleName(/\S/);
	}
	expectSize("elements of five plants: scripts, gzipped", byKind(firstLoad("dist", [...scripts])).code);
	await close();
});
