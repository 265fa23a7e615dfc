import { readFileSync } from "node:fs";
import type { Page } from "@playwright/test";
import { compressText } from "../../web/src/specimen/compressed_text";
import { expect, test } from "./fixtures";
import { dialog, openSaved } from "./saved_page";
import { StudioPage } from "./studio_page";

const section = (page: Page) => page.getByRole("region", { name: "Continue where you left off" });
const plants = (page: Page) => section(page).getByRole("listitem");
const links = (page: Page) => section(page).getByRole("link");

/** Opens the home page, as a person does that leaves a plant. */
async function goHome(page: Page): Promise<void> {
	await page.goto("./");
	await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
}

test("Undo and Redo survive a reload, across models", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	const lychee = await studio.fingerprint.innerText();
	const edited = await studio.regrown(() => studio.slider("Length").press("PageDown"));
	const crocus = await studio.regrown(() => studio.choosePreset("flower", "crocus"));
	await page.reload();
	await expect(studio.fingerprint).toHaveText(crocus);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(edited);
	// Again, in the middle of the history.
	await page.reload();
	await expect(studio.fingerprint).toHaveText(edited);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(lychee);
	await expect(studio.button("Undo")).toBeDisabled();
	await studio.button("Redo").click();
	await studio.button("Redo").click();
	await expect(studio.fingerprint).toHaveText(crocus);
	await expect(page).toHaveURL(/model=flower/);
});

test("the home page offers the last plants again: continued, removed, brought back and cleared", async ({ page }) => {
	await goHome(page);
	await expect(page.getByRole("heading", { name: "What do you want to grow?" })).toBeVisible();
	await expect(section(page)).toHaveCount(0);
	const studio = await new StudioPage(page).open("?v=2&preset=duku");
	await studio.stands();
	// Merely looked at for some time.
	await expect.poll(() => page.evaluate(stored)).toHaveLength(1);
	await studio.open("?v=2&preset=lychee");
	const lychee = await studio.fingerprint.innerText();
	const edited = await studio.regrown(() => studio.slider("Length").press("PageDown"));
	await expect(studio.button("Undo")).toBeEnabled();
	// Left at once: nothing is lost.
	await goHome(page);
	await expect(links(page)).toHaveText([/Lychee \(edited\)\s+edited just now/, /Duku\s+opened just now/]);
	await expect(plants(page).nth(1).locator("canvas")).toBeVisible();

	await links(page).first().click();
	await expect(studio.fingerprint).toHaveText(edited);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(lychee);
	await studio.button("Redo").click();
	await expect(studio.fingerprint).toHaveText(edited);
	await goHome(page);
	await expect(links(page)).toHaveText([/Lychee \(edited\)/, /Duku/]);

	await section(page).getByRole("button", { name: "Remove Lychee (edited) from this list" }).click();
	await expect(section(page).getByRole("status")).toHaveText("Removed “Lychee (edited)” from the list.");
	await expect(section(page).getByRole("button", { name: "Remove Duku from this list" })).toBeFocused();
	await page.keyboard.press("Enter");
	await expect(links(page)).toHaveCount(0);
	await expect(section(page).getByRole("button", { name: "Undo" })).toBeFocused();
	await page.keyboard.press("Enter");
	await section(page).getByRole("button", { name: "Undo" }).click();
	await expect(section(page).getByRole("status")).toHaveText("“Lychee (edited)” is back in the list.");
	await expect(links(page)).toHaveText([/Lychee \(edited\)/, /Duku/]);
	await section(page).getByRole("button", { name: "Clear list" }).click();
	await expect(section(page).getByRole("status")).toHaveText("Removed 2 plants from the list.");
	await page.reload();
	await expect(page.getByRole("heading", { name: "What do you want to grow?" })).toBeVisible();
	await expect(section(page)).toHaveCount(0);
});

/** Links in the browser's database of recent plants. */
const stored = () =>
	new Promise<string[]>((resolve) => {
		const opening = indexedDB.open("panicle.recent");
		opening.onupgradeneeded = () => opening.transaction?.abort();
		opening.onerror = () => resolve([]);
		opening.onsuccess = () => {
			const reading = opening.result.transaction("plants").objectStore("plants").getAll();
			reading.onsuccess = () => {
				opening.result.close();
				resolve(reading.result.map(({ link }) => link));
			};
		};
	});

test("the dialog of saved plants has the recent ones, which open as one step", { tag: "@long" }, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	const edited = await studio.regrown(() => studio.slider("Length").press("PageDown"));
	const duku = await studio.regrown(() => studio.choosePreset("bunch", "duku"));
	await expect.poll(() => page.evaluate(stored)).toHaveLength(2);
	await openSaved(page);
	const recent = dialog(page).getByRole("region", { name: "Recent plants" });
	// Without the plant on the controls, which is open already.
	await expect(recent.getByRole("listitem")).toHaveCount(1);
	await recent.getByRole("button", { name: /^Lychee \(edited\)/ }).click();
	await expect(dialog(page)).toBeHidden();
	await expect(studio.fingerprint).toHaveText(edited);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(duku);
	await expect(studio.notices.locator(".notice")).toHaveCount(0);
});

test("plants that two tabs edit are both offered, and more than six are not", { tag: "@long" }, async ({
	page,
	context,
	complaints,
}) => {
	const second = await context.newPage();
	complaints.listenTo(second);
	const [one, two] = [new StudioPage(page), new StudioPage(second)];
	await one.open("?v=2&preset=lychee");
	await two.open("?v=2&preset=lychee");
	await one.regrown(() => one.slider("Length").press("PageDown"));
	await two.regrown(() => two.button("New variation").click());
	await expect.poll(() => page.evaluate(stored)).toHaveLength(2);
	await one.regrown(() => one.button("New variation").click());
	await expect.poll(async () => (await page.evaluate(stored)).includes(new URL(page.url()).search)).toBe(true);
	await goHome(page);
	await expect(links(page)).toHaveCount(2);
	// Plants that are merely looked at never push out an edited one.
	for (const preset of ["duku", "rubus", "riesling", "merlot", "kyoho", "redcurrant"]) {
		await two.open(`?v=2&preset=${preset}`);
		await expect.poll(async () => (await second.evaluate(stored)).some((link) => link.includes(preset))).toBe(true);
	}
	await page.bringToFront();
	await page.reload();
	await expect(links(page)).toHaveCount(6);
	await expect(links(page).filter({ hasText: "Lychee" })).toHaveCount(2);
});

test("a page that may store nothing works without the list and without Undo over a reload", { tag: "@long" }, async ({
	page,
}) => {
	await page.addInitScript(() => {
		const refuse = () => {
			throw new DOMException("no", "SecurityError");
		};
		IDBFactory.prototype.open = refuse;
		for (const name of ["localStorage", "sessionStorage"]) Object.defineProperty(window, name, { get: refuse });
	});
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	const edited = await studio.regrown(() => studio.slider("Length").press("PageDown"));
	await page.waitForTimeout(1500);
	await page.reload();
	await expect(studio.fingerprint).toHaveText(edited);
	await expect(studio.button("Undo")).toBeDisabled();
	await openSaved(page);
	await expect(dialog(page).getByRole("region", { name: "Recent plants" })).toHaveCount(0);
	await goHome(page);
	await expect(page.getByRole("heading", { name: "What do you want to grow?" })).toBeVisible();
	await expect(section(page)).toHaveCount(0);
});

test("any data in the storage is survived, and what is no plant is not shown", { tag: "@long" }, async ({ page }) => {
	await page.addInitScript(() => {
		sessionStorage.setItem("panicle.undo", '{"v":1,"pieces":[[0,1,2,"x"]]}');
		localStorage.setItem("panicle.recent", '[{"id":"x","link":"javascript:alert(1)","title":"x","at":1}]');
	});
	await goHome(page);
	await page.evaluate(
		() =>
			new Promise<void>((resolve) => {
				const opening = indexedDB.open("panicle.recent");
				opening.onsuccess = () => {
					const transaction = opening.result.transaction(["plants", "pictures"], "readwrite");
					const store = transaction.objectStore("plants");
					for (let i = 0; i < 100; i++) store.put({ id: `foreign ${i}`, link: 7, title: {} });
					store.put({ id: "good", link: "?v=2&preset=duku", title: "<b>Duku</b>", at: 1e12 });
					transaction.objectStore("pictures").put(new Uint8Array(50), "good");
					transaction.oncomplete = () => {
						opening.result.close();
						resolve();
					};
				};
			}),
	);
	await new StudioPage(page).open("?v=2&preset=lychee");
	await expect.poll(async () => (await page.evaluate(stored)).length).toBeLessThanOrEqual(6);
	await goHome(page);
	await expect(links(page)).toHaveCount((await page.evaluate(stored)).length);
	await expect(links(page).first()).toContainText("Lychee");
});

test("a mesh that no link holds survives a reload, and is continued from the home page", { tag: "@long" }, async ({
	page,
}) => {
	const studio = new StudioPage(page);
	await page.goto("./?v=2&model=tree&preset=birch");
	await expect(studio.fingerprint).toHaveText(/^[0-9a-f]{16}$/);
	const ball = ["1 0 0", "-1 0 0", "0 2 0", "0 -1 0", "0 0 1", "0 0 -1"].map((point) => `v ${point}`);
	const faces = ["1 3 5", "3 2 5", "2 4 5", "4 1 5", "3 1 6", "2 3 6", "4 2 6", "1 4 6"].map((face) => `f ${face}`);
	const own = await studio.regrown(() => studio.drop("ball.obj", Buffer.from([...ball, ...faces].join("\n"))));
	await page.reload();
	await expect(studio.fingerprint).toHaveText(own);
	await expect(studio.notices.locator(".notice")).toHaveCount(0);
	await expect.poll(() => page.evaluate(stored)).toHaveLength(1);
	await goHome(page);
	await page.evaluate(() => sessionStorage.clear());
	await links(page).first().click();
	await expect(studio.fingerprint).toHaveText(own);
	await expect(page).not.toHaveURL(/recent=/);
	await expect(studio.notices.locator(".notice")).toHaveCount(0);
});

test("a plant with a long grammar of its own is continued, and its edits are undone after a reload", {
	tag: "@long",
}, async ({ page }) => {
	const grammar = readFileSync("wasm-core/grammars/bunch/grape-bunch-3.lsys", "utf8");
	const long = `${grammar}\n/* ${"a long comment, again and again. ".repeat(3000)} */\n`;
	const studio = await new StudioPage(page).open(`?v=2&preset=duku#g=${await compressText(long)}`);
	const own = await studio.fingerprint.innerText();
	const opened = page.url();
	await studio.slider("Length").press("PageDown");
	await expect(page).toHaveURL(/[?&]l=.*#g=/);
	await page.reload();
	await studio.button("Undo").click();
	await expect(page).toHaveURL(opened);
	await expect(studio.fingerprint).toHaveText(own);
	await goHome(page);
	await links(page).first().click();
	await expect(page).toHaveURL(opened);
	await expect(studio.fingerprint).toHaveText(own);
	await studio.button("Redo").click();
	await expect(page).toHaveURL(/[?&]l=.*#g=/);
});
