/** The element in a page that scrolls: the wheel and one finger scroll the page, unless the page gives them to the plant. */
import type { CDPSession, Page } from "@playwright/test";
import { grown, openHost, SMALL, serveLibrary } from "./element_page";
import { expect, test } from "./fixtures";
import { passFrames } from "./frames";

/** The handles show how near the plant is. */
const PLANT = `<panicle-specimen ${SMALL} handles></panicle-specimen>`;
const BELOW = '<p style="height: 3000px">Below</p>';

let library: Awaited<ReturnType<typeof serveLibrary>>;
test.beforeAll(async () => {
	library = await serveLibrary();
});
test.afterAll(() => library.close());
test.use({ hasTouch: true });

const scrolled = (page: Page) => page.evaluate(() => scrollY);
const toTop = (page: Page) => page.evaluate(() => scrollTo(0, 0));
const hint = (page: Page) => page.getByText("Hold Ctrl and scroll to zoom");

/** Height of the plant in the picture: the distance between its highest and its lowest handle, pixels. */
async function height(page: Page): Promise<number> {
	const tops = await page
		.getByRole("group", { name: "Handles" })
		.getByRole("button")
		.evaluateAll((handles) => handles.map((handle) => handle.getBoundingClientRect().y));
	return Math.max(...tops) - Math.min(...tops);
}

/** The height of the plant once it is at rest. */
async function settledHeight(page: Page): Promise<number> {
	let last = Number.NaN;
	await expect(async () => {
		const before = last;
		last = await height(page);
		await passFrames(page, 3);
		expect(last).toBe(before);
		expect(last).toBeGreaterThan(20);
	}).toPass();
	return last;
}

/** The centre of the view, pixels of the window. */
async function centre(page: Page): Promise<{ x: number; y: number }> {
	const box = await page.getByRole("application").boundingBox();
	if (!box) throw new Error("The plant is not on the page.");
	return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Moves one or two fingers across the plant: each from and to a point, relative to the centre of the view. */
async function swipe(
	page: Page,
	session: CDPSession,
	fingers: readonly (readonly [from: readonly [number, number], to: readonly [number, number]])[],
): Promise<void> {
	const { x, y } = await centre(page);
	const at = (share: number) =>
		fingers.map(([from, to], id) => ({
			id,
			x: x + from[0] + (to[0] - from[0]) * share,
			y: y + from[1] + (to[1] - from[1]) * share,
		}));
	const touch = (type: "touchStart" | "touchMove" | "touchEnd", touchPoints: ReturnType<typeof at>) =>
		session.send("Input.dispatchTouchEvent", { type, touchPoints });
	await touch("touchStart", at(0));
	for (let step = 1; step <= 10; step++) await touch("touchMove", at(step / 10));
	await touch("touchEnd", []);
}

async function open(page: Page, body: string): Promise<() => Promise<void>> {
	const close = await openHost(page, library.address, body);
	await grown(page);
	return close;
}

test("the wheel scrolls the page, also after a click on the plant, and a hint says how it zooms", async ({ page }) => {
	const close = await open(page, PLANT + BELOW);
	const before = await settledHeight(page);
	const { x, y } = await centre(page);
	await page.mouse.click(x, y + 100);
	await page.mouse.wheel(0, 120);
	await expect.poll(() => scrolled(page)).toBeGreaterThan(50);
	await expect(hint(page)).toBeVisible();
	await expect(hint(page)).toBeHidden();
	expect(await settledHeight(page)).toBeCloseTo(before, 0);

	await test.step("but is not shown where the page scrolls under a pointer that rests", async () => {
		await page.mouse.wheel(0, 20);
		await page.waitForTimeout(200);
		await expect(hint(page)).toBeHidden();
		await toTop(page);
	});

	for (const key of ["Control", "Meta"] as const) {
		await test.step(`${key} and the wheel zoom the plant`, async () => {
			const start = await settledHeight(page);
			await page.mouse.move(x, y + 90);
			await page.keyboard.down(key);
			await page.mouse.wheel(0, -120);
			await expect.poll(() => height(page)).toBeGreaterThan(1.03 * start);
			await page.keyboard.up(key);
			expect(await scrolled(page)).toBe(0);
		});
	}

	await test.step("with the attribute `capture`, the wheel zooms the plant", async () => {
		await page.locator("panicle-specimen").evaluate((element) => element.setAttribute("capture", ""));
		const start = await settledHeight(page);
		await page.mouse.move(x, y + 80);
		await page.mouse.wheel(0, 120);
		await expect.poll(() => height(page)).toBeLessThan(0.97 * start);
		expect(await scrolled(page)).toBe(0);
		await expect(hint(page)).toBeHidden();
	});
	await close();
});

test("one finger scrolls the page up and down and turns the plant sideways, and two fingers zoom it", async ({
	page,
}) => {
	const close = await open(page, PLANT + BELOW);
	const session = await page.context().newCDPSession(page);
	const front = async () => (await page.getByRole("button", { name: /^Front: / }).boundingBox())?.x ?? Number.NaN;
	const before = await front();
	await swipe(page, session, [
		[
			[0, 100],
			[80, 100],
		],
	]);
	await expect.poll(async () => Math.abs((await front()) - before)).toBeGreaterThan(2);
	expect(await scrolled(page)).toBe(0);

	// Both fingers move up while they part: without care the browser would scroll the page.
	const start = await settledHeight(page);
	await swipe(page, session, [
		[
			[-20, 120],
			[-90, 40],
		],
		[
			[20, 120],
			[90, 40],
		],
	]);
	await expect.poll(() => height(page)).toBeGreaterThan(1.2 * start);
	expect(await scrolled(page)).toBe(0);

	const zoomed = await settledHeight(page);
	const up = [[[60, 140] as const, [60, -60] as const] as const];
	await swipe(page, session, up);
	await expect.poll(() => scrolled(page)).toBeGreaterThan(50);
	expect(Math.abs((await settledHeight(page)) / zoomed - 1)).toBeLessThan(0.03);

	await test.step("with the attribute `capture`, one finger turns the plant in all directions", async () => {
		await toTop(page);
		await page.locator("panicle-specimen").evaluate((element) => element.setAttribute("capture", ""));
		await swipe(page, session, up);
		await page.waitForTimeout(300);
		expect(await scrolled(page)).toBe(0);
	});
	await close();
});

test("a frame scrolls the page around it; in a window of its own it takes the wheel", async ({ page }) => {
	const address = `${library.address}embed.html?v=2&preset=redcurrant&count=6&handles=`;
	const close = await openHost(
		page,
		library.address,
		`<iframe title="A plant" src="${address}" width="300" height="300"></iframe>${BELOW}`,
	);
	const view = page.frameLocator("iframe").getByRole("application", { name: /^Redcurrant bunch: / });
	await expect(view).toBeVisible();
	await view.hover();
	await page.mouse.wheel(0, 120);
	await expect.poll(() => scrolled(page)).toBeGreaterThan(50);
	await expect(page.frameLocator("iframe").getByText("Hold Ctrl and scroll to zoom")).toBeVisible();

	await page.goto(address);
	await grown(page);
	await expect(page.getByRole("button", { name: /^Right: / })).toBeVisible();
	const start = await settledHeight(page);
	await page.mouse.move(40, 40);
	await page.mouse.wheel(0, 120);
	await expect.poll(() => height(page)).toBeLessThan(0.97 * start);
	await close();
});

test("the hint is in the language of the page", { tag: "@long" }, async ({ page }) => {
	const close = await open(page, `<div lang="fr">${PLANT}</div>${BELOW}`);
	const { x, y } = await centre(page);
	await page.mouse.move(x, y + 100);
	await page.mouse.wheel(0, 60);
	await expect(page.getByText("Maintenez Ctrl et faites défiler pour zoomer")).toBeVisible();
	await close();
});
