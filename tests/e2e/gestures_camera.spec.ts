/** Gestures before a camera: a file of its own, since the fake camera takes a browser of its own. */
import type { Page } from "@playwright/test";
import config from "../../playwright.config";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

// A camera that shows a clock, and is allowed without a question.
const { launchOptions } = config.use ?? {};
const args = ["--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream"];
test.use({
	permissions: ["camera"],
	launchOptions: { ...launchOptions, args: [...(launchOptions?.args ?? []), ...args] },
});

const FLOWER = "?v=2&model=flower&preset=tulip";
const circle = (page: Page) => page.getByRole("button", { name: /^bend/ });

/** Stands in for @mediapipe/hands: every picture has the hand that the test puts into `globalThis.hand`. */
const INJECTED = `globalThis.CanvasInteraction = class {
	setOptions() {}
	onResults(listener) { this.listener = listener; }
	async initialize() {}
	async send({ image }) {
		if (!(image instanceof HTMLVideoElement)) throw new Error("no picture");
		this.listener({ multiHandLandmarks: globalThis.hand ? [globalThis.hand] : [] });
	}
	async close() { globalThis.closed = true; }
};`;

/** Hand landmarks with the centre of the palm at a position in the camera's picture. */
function handAt(x: number, y: number, pinching = false) {
	const points = Array.from({ length: 21 }, () => ({ x, y }));
	points[0] = { x, y: y + 0.06 };
	points[5] = { x: x - 0.03, y: y - 0.03 };
	points[17] = { x: x + 0.03, y: y - 0.03 };
	points[9] = { x, y: y - 0.04 };
	points[8] = { x: pinching ? x : x + 0.1, y };
	return points;
}

test("a hand drives the two numbers, and a pinch brings the next two, which wait for it", { tag: "@long" }, async ({
	page,
}) => {
	await page.route("**/hands/hands.js", (route) => route.fulfill({ contentType: "text/javascript", body: INJECTED }));
	const studio = await new StudioPage(page).open(FLOWER);
	const put = (hand: unknown) => page.evaluate((there) => Object.assign(globalThis, { hand: there }), hand);
	const bar = page.getByRole("group", { name: "Gestures" });
	await studio.button("Gestures").click();
	await bar.getByLabel("Control with").selectOption("Hand (webcam)");
	await expect(bar.getByText("neither sent nor kept")).toBeVisible();
	await expect(bar.getByRole("status")).toContainText("No hand detected");
	const before = await circle(page).getAttribute("aria-label");
	await put(handAt(0.7, 0.4));
	await expect(bar.getByRole("status")).toContainText("Hand detected");
	await expect(circle(page)).not.toHaveAccessibleName(before ?? "");
	const left = await circle(page).evaluate((element) => Number.parseFloat(element.style.left));
	expect(left).toBeLessThan(35);
	await put(handAt(0.7, 0.4, true));
	await expect(circle(page)).toHaveCount(0);
	const next = page.getByRole("button", { name: /,/ }).and(page.locator(".gesture-circle"));
	const waiting = await next.getAttribute("aria-label");
	await put(handAt(0.71, 0.41));
	expect(await next.getAttribute("aria-label")).toBe(waiting);
	await put(undefined);
	await expect(bar.getByRole("status")).toContainText("No hand detected");
	await page.keyboard.press("ControlOrMeta+z");
	await bar.getByLabel("Across").selectOption("bend");
	await bar.getByLabel("Up").selectOption("length");
	await expect(circle(page)).toHaveAccessibleName(before ?? "");
});

test("what finds hands is the app's own, finds none in a picture without, and lets go of the camera", {
	tag: "@long",
}, async ({ page }) => {
	const requested: string[] = [];
	page.on("request", (request) => requested.push(request.url()));
	const studio = await new StudioPage(page).open(FLOWER);
	expect(requested.filter((url) => url.includes("/hands"))).toEqual([]);
	const bar = page.getByRole("group", { name: "Gestures" });
	await studio.button("Gestures").click();
	await bar.getByLabel("Control with").selectOption("Hand (webcam)");
	await expect(bar.getByRole("status")).toContainText("No hand detected", { timeout: 60_000 });
	const found = requested.filter((url) => /hands/.test(url)).map((url) => new URL(url));
	expect(found.length).toBeGreaterThan(4);
	expect(found.every(({ origin }) => origin === new URL(page.url()).origin)).toBe(true);
	const live = () =>
		page.evaluate(() => document.querySelector<HTMLVideoElement>(".gestures video")?.srcObject !== null);
	expect(await live()).toBe(true);
	// A camera that is taken away is let go, and may be chosen again.
	await page.evaluate(() => {
		const { srcObject } = document.querySelector<HTMLVideoElement>(".gestures video") ?? {};
		for (const track of (srcObject as MediaStream).getTracks()) track.dispatchEvent(new Event("ended"));
	});
	await expect(bar.getByRole("status")).toContainText("The camera has gone");
	await expect(bar.getByLabel("Control with")).toHaveValue("pointer");
	await bar.getByLabel("Control with").selectOption("Hand (webcam)");
	await expect(bar.getByRole("status")).toContainText("No hand detected", { timeout: 60_000 });
	await studio.button("Gestures").click();
	expect(await live()).toBe(false);
});
