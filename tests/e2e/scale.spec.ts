import { expect, test } from "./fixtures";
import { endsOf, HEIGHT, openStick, viewOf } from "./measured_stick";
import { StudioPage } from "./studio_page";

const METRES = { mm: 0.001, cm: 0.01, m: 1 } as const;

test.describe("drawn", () => {
	test.use({ drawn: true });

	test("the scale bar agrees with a plant of known height, and follows the zoom", { tag: "@long" }, async ({
		page,
	}) => {
		const studio = await openStick(page);
		const bar = page.locator(".scale-bar");
		/** The scale, by the bar and by the plant, metres per pixel. */
		const scales = async () => {
			const { top, foot } = await endsOf(studio);
			const [, count, unit] = (await bar.innerText()).match(/^([125]0*) (mm|cm|m)$/) ?? [];
			const line = await page.locator(".scale-line").boundingBox();
			const length = Number(count) * METRES[unit as keyof typeof METRES];
			return { bar: length / (line?.width ?? 0), plant: HEIGHT / (foot.y - top.y) };
		};
		const whole = await scales();
		await viewOf(page).focus();
		for (let i = 0; i < 4; i++) await page.keyboard.press("-");
		const small = await scales();
		expect(small.bar / whole.bar).toBeGreaterThan(1.5);
		expect(Math.abs(small.bar / small.plant - 1)).toBeLessThan(0.02);
		expect(Math.abs(whole.bar / whole.plant - 1)).toBeLessThan(0.02);
	});
});

test("the scale bar is for the eye, written large enough, and can be hidden for good", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	const bar = page.locator(".scale-bar");
	await expect(bar).toHaveText(/^[125]0* (mm|cm)$/);
	await expect(bar).toHaveAttribute("aria-hidden", "true");
	expect(await bar.evaluate((element) => Number.parseFloat(getComputedStyle(element).fontSize))).toBeGreaterThanOrEqual(
		12,
	);
	const toggle = async () => {
		await page.keyboard.press("Control+k");
		await page.getByRole("combobox", { name: "Search plants" }).fill("scale bar");
		await page.getByRole("option", { name: /^Scale bar on\/off/ }).click();
	};
	await toggle();
	await expect(bar).toHaveCount(0);
	await page.reload();
	await studio.stands();
	await toggle();
	await expect(bar).toBeVisible();
});

test("the scale bar of a tree is in metres", async ({ page }) => {
	await new StudioPage(page).open("?v=2&model=growth&preset=oak");
	await expect(page.locator(".scale-bar")).toHaveText(/^[125]0* m$/);
});
