import { expect, test } from "./fixtures";
import { framesRequested } from "./frames";
import { StudioPage } from "./studio_page";
import { openViews, serveViews } from "./views_page";

test("a button has the wind blow, and nothing is drawn when it is over", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	await studio.stands();
	const wind = studio.button("Wind on/off");
	await expect(wind).toHaveAttribute("aria-pressed", "false");
	await expect.poll(() => framesRequested(page)).toBe(0);
	await wind.press("Enter");
	await expect(wind).toHaveAttribute("aria-pressed", "true");
	await expect.poll(() => framesRequested(page)).toBeGreaterThan(3);
	await test.step("another plant stands in it, too", async () => {
		await page.locator("[data-preset=merlot]").click();
		await expect(page).toHaveTitle(/Merlot/);
		await expect.poll(() => framesRequested(page)).toBeGreaterThan(3);
	});
	await wind.press("Enter");
	await expect(wind).toHaveAttribute("aria-pressed", "false");
	await expect.poll(() => framesRequested(page)).toBe(0);
});

test("there is no wind where less motion is wished for, nor for a root", { tag: "@long" }, async ({ page }) => {
	await page.emulateMedia({ reducedMotion: "reduce" });
	const studio = await new StudioPage(page).open();
	await expect(studio.button("Reset view")).toBeVisible();
	await expect(studio.button("Wind on/off")).toHaveCount(0);
	await page.emulateMedia({ reducedMotion: "no-preference" });
	await studio.button("Wind on/off").click();
	await expect.poll(() => framesRequested(page)).toBeGreaterThan(3);
	await page.emulateMedia({ reducedMotion: "reduce" });
	await expect.poll(() => framesRequested(page)).toBe(0);
	await page.emulateMedia({ reducedMotion: "no-preference" });
	await expect(studio.button("Wind on/off")).toHaveAttribute("aria-pressed", "false");
	await studio.choosePreset("root", "carrot");
	await expect(page.getByRole("application", { name: /^Root/ })).toBeVisible();
	await expect(studio.button("Wind on/off")).toHaveCount(0);
});

test.describe("to the eye", () => {
	test.use({ drawn: true });
	let host: Awaited<ReturnType<typeof serveViews>>;
	test.beforeAll(async () => {
		host = await serveViews();
	});
	test.afterAll(() => host.close());

	/** A bunch's own shaders, and three's with a shadow map. */
	for (const figure of ["bunchRenderer", "partRenderer"] as const) {
		test(`what ${figure} draws sways while the wind blows, and is at rest before, after and in pictures`, {
			tag: "@long",
		}, async ({ page }) => {
			await openViews(page, host.address);
			const { moved, pictured, left } = await page.evaluate(async (figure) => {
				const { bunchRenderer, bunchParts, canvas, grow, partRenderer, pixels, swayOf, Viewer } = window.views;
				const [side, drawn] = [96, canvas(96, 96)];
				const copy = new OffscreenCanvas(side, side).getContext("2d", {
					willReadFrequently: true,
				}) as OffscreenCanvasRenderingContext2D;
				const frames: Uint8ClampedArray[] = [];
				const viewer = new Viewer<ReturnType<typeof grow>["specimen"], ReturnType<typeof grow>["grown"]>(drawn, {
					still: true,
					reducedMotion: true,
					checked: true,
					events: {
						// A canvas keeps its drawing until the task ends.
						drawn: () => {
							copy.drawImage(drawn, 0, 0, side, side);
							frames.push(copy.getImageData(0, 0, side, side).data);
						},
					},
				});
				const { grown, specimen } = grow("?v=2&preset=redcurrant&count=20");
				const parts = () => bunchParts(grown, specimen);
				viewer.use(figure === "bunchRenderer" ? bunchRenderer : partRenderer(parts, undefined, swayOf));
				viewer.show(grown, specimen);
				await viewer.whenIdle();
				const rest = frames[frames.length - 1];
				const unlike = (one: Uint8ClampedArray, other: Uint8ClampedArray) =>
					one.filter((level, at) => Math.abs(level - other[at]) > 8).length;
				const before = await pixels(await viewer.snapshot(side, side));
				viewer.wind = true;
				// Gusts are weak at first: some seconds of frames, and more until one differs much.
				for (let i = 0; i < 120 || (i < 600 && unlike(rest, frames[frames.length - 1]) <= 800); i++)
					await new Promise(requestAnimationFrame);
				const blown = frames[frames.length - 1];
				const during = await pixels(await viewer.snapshot(side, side));
				viewer.wind = false;
				await viewer.whenIdle();
				return {
					moved: unlike(rest, blown),
					pictured: unlike(before.data, during.data),
					left: unlike(rest, frames[frames.length - 1]),
				};
			}, figure);
			expect(moved).toBeGreaterThan(100);
			// As where an edge goes just through a pixel.
			expect(Math.max(pictured, left)).toBeLessThan(20);
		});
	}
});
