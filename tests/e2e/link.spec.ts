import { readFileSync } from "node:fs";
import type { Page } from "@playwright/test";
import { compressText } from "../../web/src/specimen/compressed_text";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("the copied link brings the same bunch back", async ({ page, context, complaints }) => {
	await context.grantPermissions(["clipboard-read", "clipboard-write"]);
	const studio = await new StudioPage(page).open("?v=2&preset=grape-15b");
	await studio.openAdvanced();
	await studio.slider("Right width").press("PageDown");
	await studio.regrown(() => studio.button("New variation").click());
	const sheet = await studio.openShare();
	// The button has the focus.
	await expect(sheet.getByRole("button", { name: "Copy link" })).toBeFocused();
	await page.keyboard.press("Enter");
	await expect(sheet.locator(".result:not(:empty)")).toHaveText("Link copied");
	const link = await page.evaluate(() => navigator.clipboard.readText());
	expect(link).toBe(page.url());
	expect(new URL(link).search.length).toBeLessThan(200);
	const other = await context.newPage();
	complaints.listenTo(other);
	await other.goto(link);
	await expect(other.locator("[data-fingerprint]")).toHaveText(await studio.fingerprint.innerText());
	await expect(other.locator("panicle-notices")).not.toContainText("could not be read");
});

test("where copying is denied, the link is selected for copying by hand", { tag: "@long" }, async ({ page }) => {
	await page.addInitScript(() => {
		Object.defineProperty(navigator, "clipboard", { value: { writeText: () => Promise.reject(new Error("denied")) } });
	});
	const studio = await new StudioPage(page).open("?v=2&preset=duku");
	const sheet = await studio.openShare();
	await sheet.getByRole("button", { name: "Copy link" }).click();
	const link = sheet.getByRole("textbox", { name: "Link", exact: true });
	await expect(link).toBeFocused();
	await expect(link).toHaveValue(/\?v=2&preset=duku$/);
	await expect(sheet.locator(".result:not(:empty)")).toContainText("The link is selected");
	expect(await page.evaluate(() => getSelection()?.toString())).toMatch(/preset=duku$/);
});

test("a malformed link opens what it can and says what it could not, until dismissed", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=duku&l=9000&p3=abc&seed=-4&colour=red");
	const { notices } = studio;
	await expect(notices).toContainText("Some of this link could not be read");
	await expect(notices).toContainText("9000 is above the maximum, 580.");
	for (const part of ["p3", "seed", "colour"]) await expect(notices).toContainText(`${part}:`);
	await expect(studio.slider("Length")).toHaveValue("580");
	await expect(page).toHaveURL(/\?v=2&preset=duku&seed=0&l=580$/);
	// In all sizes it stands over no plant.
	for (const [width, height] of [
		[1440, 900],
		[720, 450],
		[390, 844],
	]) {
		await page.setViewportSize({ width, height });
		const [notice, plant] = await Promise.all([page.locator(".notice").boundingBox(), studio.canvas.boundingBox()]);
		if (!notice || !plant) throw new Error("There is no notice or no view.");
		const apart =
			notice.x >= plant.x + plant.width || notice.y >= plant.y + plant.height || notice.y + notice.height <= plant.y;
		expect(apart, `${width} × ${height}`).toBe(true);
		const caption = await page.locator(".caption h2").boundingBox();
		expect(caption?.y, `${width} × ${height}`).toBeGreaterThan(plant.y + plant.height - 12);
	}
	await notices.getByRole("button", { name: "Dismiss" }).click();
	await expect(notices.getByRole("listitem")).toHaveCount(0);
});

test("an unknown preset or a nonsense query still shows a bunch", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?preset=%3Cscript%3E&v=999&&&=%ff");
	await expect(studio.notices).toContainText("There is no preset");
	await expect(page.locator("[data-preset=long-conical]")).toHaveAttribute("aria-current", "true");
});

const preset = (page: Page, name: string) => page.locator(`[data-preset=${name}]`);

test("Back brings the last preset as it was left, Forward the next; edits are no entries", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	await studio.regrown(() => studio.slider("Length").press("PageDown"));
	const lychee = await studio.fingerprint.innerText();
	const left = page.url();
	const rubus = await studio.regrown(() => preset(page, "rubus").click());
	await studio.regrown(() => preset(page, "duku").click());
	await page.goBack();
	await expect(studio.fingerprint).toHaveText(rubus);
	await expect(preset(page, "rubus")).toHaveAttribute("aria-current", "true");
	await page.goBack();
	await expect(studio.fingerprint).toHaveText(lychee);
	expect(page.url()).toBe(left);
	await page.goForward();
	await expect(studio.fingerprint).toHaveText(rubus);
});

test("Undo and Back go the same way: what one has left the other finds", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	const lychee = await studio.fingerprint.innerText();
	const rubus = await studio.regrown(() => preset(page, "rubus").click());
	await page.goBack();
	await expect(studio.fingerprint).toHaveText(lychee);
	await expect(studio.button("Undo")).toBeDisabled();
	await studio.button("Redo").click();
	await expect(studio.fingerprint).toHaveText(rubus);
	await expect(page).toHaveURL(/preset=rubus/);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(lychee);
	await page.goBack();
	await expect(studio.fingerprint).toHaveText(rubus);
	await page.goBack();
	await expect(studio.fingerprint).toHaveText(lychee);
	await expect(page).toHaveURL(/preset=lychee/);
});

test("a grammar in the fragment outlives the skip link, and fragments that are none of ours", { tag: "@long" }, async ({
	page,
}) => {
	const text = `/* mine */\n${readFileSync("wasm-core/grammars/bunch/grape-bunch-3.lsys", "utf8")}`;
	const studio = await new StudioPage(page).open(`?preset=duku#g=${await compressText(text)}`);
	await expect(page).toHaveURL(/#g=/);
	const [own, address] = [await studio.fingerprint.innerText(), page.url()];
	await page.keyboard.press("Tab");
	await page.keyboard.press("Enter");
	await expect(page.getByRole("complementary")).toBeFocused();
	expect(page.url()).toBe(address);
	for (const fragment of ["#controls", "#nonsense"]) {
		await page.evaluate((hash) => {
			location.hash = hash;
		}, fragment);
		await expect(page).toHaveURL(address);
		await expect(studio.button("Undo")).toBeDisabled();
		await expect(studio.fingerprint).toHaveText(own);
	}
});

test("a link of ours in the fragment opens, as a step that can be undone", { tag: "@long" }, async ({ page }) => {
	const text = `/* mine */\n${readFileSync("wasm-core/grammars/bunch/grape-bunch-3.lsys", "utf8")}`;
	const studio = await new StudioPage(page).open("?v=2&preset=duku&procedure=paper");
	const packed = await compressText(text.replace(/#define near [\d.]+/, "#define near 0.9"));
	await page.evaluate((hash) => {
		location.hash = hash;
	}, `g=${packed}`);
	await studio.openGroup("Branching");
	await expect(page.getByText("This plant has its own grammar.")).toBeVisible();
	await studio.button("Undo").click();
	await expect(page.getByText("This plant has its own grammar.")).toHaveCount(0);
	await expect(page).not.toHaveURL(/#g=/);
});

test("choosing a preset from the gallery is a link and one undo step", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open();
	const first = await studio.fingerprint.innerText();
	await studio.regrown(() => page.getByRole("button", { name: "Redcurrant" }).click());
	await expect(page).toHaveURL(/preset=redcurrant/);
	await expect(page.locator("[data-preset=redcurrant]")).toHaveAttribute("aria-current", "true");
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(first);
});

test("inputs that a link sets are shown, and can follow the profile again", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?m=3&n=1,2");
	await expect(studio.readout("Rachis segments")).toHaveText("3");
	await studio.openAdvanced();
	await expect(page.getByText("Set by the link instead of the profile: m = 3; n = 1, 2.")).toBeVisible();
	await studio.regrown(() => studio.button("Follow the profile").click());
	await expect(studio.readout("Rachis segments")).toHaveText("18");
	await expect(page).not.toHaveURL(/[?&]m=/);
});

test("a link with a grammar of its own opens without a step to undo, and grows by it", { tag: "@long" }, async ({
	page,
}) => {
	const text = `/* mine */\n${readFileSync("wasm-core/grammars/bunch/grape-bunch-3.lsys", "utf8")}`;
	const studio = await new StudioPage(page).open(`?preset=duku#g=${await compressText(text)}`);
	await studio.openGroup("Branching");
	await expect(page.getByText("This plant has its own grammar.")).toBeVisible();
	await expect(page).toHaveURL(/#g=/);
	await expect(studio.button("Undo")).toBeDisabled();
	await studio.slider("Length").press("PageDown");
	await studio.button("Undo").click();
	await expect(page.getByText("This plant has its own grammar.")).toBeVisible();
	await expect(studio.button("Undo")).toBeDisabled();
});
