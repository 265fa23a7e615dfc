import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const TEXT = "/* Fork\n */\n#define spread 40\naxiom: F [ +(spread) F S(0.3) ] [ -(spread) F S(0.2) ] F\n";

test("a dropped .lsys grows, is its link, and is undone; its own file brings it back", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	await studio.regrown(() => studio.drop("fork.lsys", Buffer.from(TEXT)));
	await expect(page).toHaveTitle("Fork 1 · Panicle");
	await expect(page).toHaveURL(/model=grammar#g=/);
	await expect(page.getByRole("application", { name: "Grammar: 12 modules, 4 segments, 2 organs" })).toBeVisible();
	const grown = await studio.fingerprint.innerText();
	const { name, bytes } = await studio.download("lsys");
	expect(name).toMatch(/\.lsys$/);
	expect(bytes.toString()).toBe(TEXT);

	const link = page.url();
	await studio.regrown(() => studio.button("Undo").click());
	await expect(page).not.toHaveURL(/model=grammar/);
	const choosing = page.waitForEvent("filechooser");
	await studio.button("Open…").click();
	await (await choosing).setFiles({ name, mimeType: "text/plain", buffer: bytes });
	await expect(studio.fingerprint).toHaveText(grown);
	await page.goto("about:blank");
	await page.goto(link);
	await expect(studio.fingerprint).toHaveText(grown);
});

test("a wrong text is reported with its place, and the plant stays; a bunch's text grows a bunch", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=grammar");
	const grown = await studio.fingerprint.innerText();
	await studio.drop("broken.lsys", Buffer.from("axiom: F [ F\n"));
	await expect(studio.notices).toContainText(/Line 1, column \d+/);
	await expect(studio.fingerprint).toHaveText(grown);
	await studio.drop("empty.lsys", Buffer.from(" \n"));
	await expect(studio.notices).toContainText("empty.lsys is empty.");
	await studio.regrown(() => studio.drop("b.lsys", Buffer.from("#role pedicel Ap\naxiom: Ap\nAp --> F(30) S(12)\n")));
	await expect(page).toHaveURL(/\?v=2#g=/);
});

test("the strip of trees has the L-systems, and the method filters it", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=grammar");
	await studio.presetsListed();
	await page.getByRole("combobox", { name: "Method" }).selectOption("L-systems");
	await expect(page.locator(".strip section:not([data-model=grammar])")).toHaveCount(0);
	await expect(page.locator(".preset[data-preset=shrub]")).toHaveAttribute("aria-current", "true");
	await studio.regrown(() => studio.slider("Unit length").fill("20"));
	await expect(page).toHaveURL(/unit=20/);
});
