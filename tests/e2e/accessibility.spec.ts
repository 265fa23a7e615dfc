/**
 * Accessibility, measured (WCAG 2.2 AA): the rules of axe-core, sizes of texts and targets, the outline of headings, text
 * spacing, zoom, more contrast and less motion, on every page, pane and dialog.
 */
import type { Page } from "@playwright/test";
import { families, queryOf } from "../../web/src/app/home/families";
import { violations } from "./axe";
import { DIALOGS, openDialog } from "./dialogs";
import { grown, openHost, SMALL, serveLibrary } from "./element_page";
import { expect, test } from "./fixtures";
import {
	clippedTexts,
	defineMeasures,
	headings,
	setTextSpacing,
	skippedLevels,
	smallTargets,
	smallTexts,
} from "./measures";
import { StudioPage } from "./studio_page";

const DESKTOP = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844 };
/** A window of 1280 × 1024 at 400 %. */
const ZOOMED = { width: 320, height: 256 };

const SIZES = { desktop: DESKTOP, phone: PHONE };
type Size = keyof typeof SIZES;
type Theme = "light" | "dark";
type Look = readonly [size: Size, theme: Theme];

/** Every size in both themes. */
const ALL_LOOKS: readonly Look[] = [
	["desktop", "light"],
	["desktop", "dark"],
	["phone", "light"],
	["phone", "dark"],
];
/** Both themes at one size. */
const DESKTOP_LOOKS: readonly Look[] = [
	["desktop", "light"],
	["desktop", "dark"],
];
/** Each size and each theme once, for the short run. */
const TWO_LOOKS: readonly Look[] = [
	["desktop", "light"],
	["phone", "dark"],
];

/** Time for one page in all looks, ms. */
const LONG = 400_000;

test.use({ viewport: DESKTOP });
test.beforeEach(async ({ page }) => {
	await page.addInitScript(defineMeasures);
});

/** Waits until transitions have ended and the layout of a new size is drawn. */
const settled = (page: Page) =>
	page.evaluate(async () => {
		for (let i = 0; i < 3; i++) await new Promise(requestAnimationFrame);
		await Promise.allSettled(document.getAnimations().map(({ finished }) => finished));
	});

/** Expects that a page breaks no rule, in the looks given. */
async function expectAccessible(page: Page, place: string, looks: readonly Look[] = ALL_LOOKS): Promise<void> {
	let measured: Size | undefined;
	for (const [size, colorScheme] of looks) {
		await test.step(`${place}, ${size}, ${colorScheme}`, async () => {
			await page.setViewportSize(SIZES[size]);
			await page.emulateMedia({ colorScheme });
			await settled(page);
			expect.soft(await violations(page), `${place}, ${size}, ${colorScheme}: rules`).toEqual([]);
			if (measured === size) return;
			measured = size;
			expect.soft(await smallTexts(page), `${place}, ${size}: texts below 12 px`).toEqual([]);
			expect.soft(await smallTargets(page), `${place}, ${size}: targets below 24 px`).toEqual([]);
			expect.soft(skippedLevels(await headings(page)), `${place}, ${size}: outline of headings`).toEqual([]);
		});
	}
	await page.setViewportSize(DESKTOP);
	await page.emulateMedia({ colorScheme: "light" });
}

/** Expects that no text is cut off and nothing scrolls sideways with wide text spacing, also at 400 %. */
async function expectNothingLost(page: Page, place: string): Promise<void> {
	for (const viewport of [DESKTOP, PHONE, ZOOMED]) {
		await page.setViewportSize(viewport);
		for (const spaced of viewport === ZOOMED ? [false, true] : [true]) {
			const where = `${place}, ${viewport.width} px${spaced ? ", wide spacing" : ""}`;
			await setTextSpacing(page, spaced);
			await settled(page);
			expect.soft(await clippedTexts(page), `${where}: texts cut off`).toEqual([]);
			const sideways = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
			expect.soft(sideways, `${where}: scrolls sideways`).toBeLessThanOrEqual(0);
		}
		await setTextSpacing(page, false);
	}
	await page.setViewportSize(DESKTOP);
}

/** Opens the studio with all groups of the panel unfolded. */
async function openStudio(page: Page, query: string): Promise<StudioPage> {
	const studio = new StudioPage(page);
	await page.goto(query);
	await expect(studio.fingerprint).toHaveText(/^[0-9a-f]{16}$/, { timeout: 90_000 });
	await expect(page.locator("panicle-gallery[data-models='8']")).toBeAttached({ timeout: 60_000 });
	// Groups within groups come with the outer ones.
	for (let i = 0; i < 2; i++) {
		await page.evaluate(() => {
			for (const summary of document.querySelectorAll<HTMLElement>(".panel details:not([open]) > summary"))
				summary.click();
		});
		await settled(page);
	}
	return studio;
}

const openHome = async (page: Page) => {
	await page.goto("./");
	await expect(page.locator(".family")).toHaveCount(8);
};

test("the home page and the studio break no rule and lose no text", async ({ page }) => {
	await openHome(page);
	await expectAccessible(page, "home", TWO_LOOKS);
	await expectNothingLost(page, "home");
	const studio = await openStudio(page, "?v=2&model=bunch&preset=redcurrant&count=12");
	await expectAccessible(page, "studio", TWO_LOOKS);
	await expectNothingLost(page, "studio");
	await studio.browse();
	await expectAccessible(page, "gallery", [["desktop", "dark"]]);
});

test.describe("everywhere", { tag: "@long" }, () => {
	test("the home page, also with results of its search", async ({ page }) => {
		test.setTimeout(LONG);
		await openHome(page);
		await expectAccessible(page, "home");
		await page.getByRole("searchbox").fill("rose");
		await expect(page.locator(".found-plant").first()).toBeVisible();
		await expectAccessible(page, "home with results");
		await expectNothingLost(page, "home with results");
	});

	for (const { key, model, preset } of families()) {
		test(`the studio with ${key}, its panes and its views`, async ({ page }) => {
			test.setTimeout(LONG);
			// A vineyard takes ten times as long in each size as a smaller garden with the same panes.
			await openStudio(page, queryOf(model, key === "gardens" ? "orchard" : preset));
			await expectAccessible(page, key);
			await expectNothingLost(page, key);
			for (const enlarge of await page.getByRole("button", { name: /^Enlarge: / }).all()) {
				const name = await enlarge.getAttribute("aria-label");
				await enlarge.click();
				await expectAccessible(page, `${key}, ${name}`, DESKTOP_LOOKS);
				await page.keyboard.press("Escape");
			}
			const switches = page.getByRole("toolbar").locator("button[aria-pressed=false]");
			const names = await switches.evaluateAll((all) => all.map(({ ariaLabel }) => ariaLabel ?? ""));
			// The wind adds nothing to the page, and draws without end.
			for (const name of names.filter((each) => each !== "Wind on/off")) {
				const button = page.getByRole("toolbar").getByRole("button", { name, exact: true });
				await button.click();
				await expect(button).toHaveAttribute("aria-pressed", "true");
				await expectAccessible(page, `${key}, ${name}`);
				await expectNothingLost(page, `${key}, ${name}`);
				const steps = page.getByRole("button", { name: "Steps", exact: true });
				if (name === "Grammar" && (await steps.isVisible())) {
					await steps.click();
					await expectAccessible(page, `${key}, Steps`);
					await expectNothingLost(page, `${key}, Steps`);
				}
				await button.click();
			}
		});
	}

	test("notices, and what is selected in a picture", async ({ page }) => {
		test.setTimeout(LONG);
		const studio = await openStudio(page, "?v=2&model=stand&preset=orchard");
		await page.getByRole("spinbutton", { name: "Plant" }).fill("3");
		await page.keyboard.press("Enter");
		await expect(page.getByRole("group", { name: "Selected plant" })).toBeVisible();
		await studio.drop("broken.lsys", Buffer.from("axiom: F [ F\n"));
		await expect(studio.notices).toContainText(/Line 1, column \d+/);
		await expectAccessible(page, "notices and selection");
		await expectNothingLost(page, "notices and selection");
	});

	test("the element in another page, with its bar, handles, pause and hint", async ({ page }) => {
		const library = await serveLibrary();
		const plant = `<panicle-specimen ${SMALL} controls handles wind></panicle-specimen>`;
		const close = await openHost(page, library.address, `<main><h1>Plants</h1>${plant}</main>`);
		await grown(page);
		await expect(page.getByRole("group", { name: "Controls" })).toBeVisible();
		await expect(page.getByRole("button", { name: "Pause the wind" })).toBeVisible();
		await page.getByRole("button", { name: "Pause the wind" }).click();
		for (const [turn, colorScheme] of (["light", "dark"] as const).entries()) {
			await page.emulateMedia({ colorScheme });
			await page.mouse.move(150, 300 + turn);
			await page.mouse.wheel(0, 20);
			await expect(page.getByText("Hold Ctrl and scroll to zoom")).toBeVisible();
			expect.soft(await violations(page), `element, ${colorScheme}: rules`).toEqual([]);
			expect.soft(await smallTargets(page), "element: targets below 24 px").toEqual([]);
			expect.soft(await smallTexts(page), "element: texts below 12 px").toEqual([]);
			await expect(page.getByText("Hold Ctrl and scroll to zoom")).toBeHidden();
		}
		await close();
		await library.close();
	});

	test("the designer of flowers", async ({ page }) => {
		test.setTimeout(LONG);
		await openStudio(page, "?v=2&model=flower&preset=designed-buttercup");
		await expectAccessible(page, "designer");
		await expectNothingLost(page, "designer");
		for (const enlarge of await page.getByRole("button", { name: /^Enlarge: / }).all()) {
			const name = await enlarge.getAttribute("aria-label");
			await enlarge.click();
			await expectAccessible(page, `designer, ${name}`, DESKTOP_LOOKS);
			await page.keyboard.press("Escape");
		}
	});

	for (const place of DIALOGS) {
		const { name } = place;
		test(`the dialog “${name}”`, async ({ page }) => {
			test.setTimeout(LONG);
			const dialog = await openDialog(await openStudio(page, "?v=2&model=bunch&preset=redcurrant&count=12"), place);
			await expectAccessible(page, name);
			await expectNothingLost(page, name);
			await page.keyboard.press("Escape");
			await expect(dialog).toBeHidden();
		});
	}
});
