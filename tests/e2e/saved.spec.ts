import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures";
import { cards, dialog, exported, imported, inDialog, libraryOf, names, openSaved, save, status } from "./saved_page";
import { StudioPage } from "./studio_page";

/** As when the person clears the browser's data. */
const forget = (page: Page) =>
	page.evaluate(
		() =>
			new Promise<void>((resolve, reject) => {
				const request = indexedDB.deleteDatabase("panicle.saved");
				request.onsuccess = () => resolve();
				request.onblocked = () => reject(new Error("blocked"));
			}),
	);

/** Whether writing fails as it does where the disk is full. */
const fill = (page: Page, full: boolean) =>
	page.evaluate((on) => {
		const store = IDBObjectStore.prototype as IDBObjectStore & { whole?: IDBObjectStore["put"] };
		store.whole ??= store.put;
		const refuse = () => {
			throw new DOMException("full", "QuotaExceededError");
		};
		store.put = on ? refuse : store.whole;
	}, full);

test("what is saved is there again: searched, opened as one step, renamed, deleted and brought back", async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&preset=riesling&seed=4");
	await openSaved(page);
	await expect(dialog(page)).toContainText("No saved plants yet.");
	await expect(dialog(page)).toContainText("Stored in this browser only; nothing is sent anywhere.");
	await expect(inDialog(page, "Export all")).toBeDisabled();
	const name = dialog(page).getByLabel("Name", { exact: true });
	await expect(name).toBeFocused();
	await expect(name).toHaveValue("Riesling");
	await save(page);
	await expect(status(page)).toHaveText("Saved as “Riesling”.");
	await expect(name).toHaveValue("Riesling 2");
	await save(page, "Riesling");
	await expect(status(page)).toHaveText("Saved as “Riesling 2”, because there is already a plant named “Riesling”.");
	const riesling = await studio.fingerprint.innerText();
	await page.keyboard.press("Escape");
	await expect(dialog(page)).toBeHidden();
	await studio.regrown(() => studio.choosePreset("flower", "crocus"));
	await page.locator("body").press("Control+s");
	await expect(name).toHaveValue("Crocus");
	await save(page, "  My\tfirst crocus ");

	// They outlast the page, and are pictured.
	await new StudioPage(page).open("?v=2&preset=duku");
	const duku = await studio.fingerprint.innerText();
	await openSaved(page);
	await expect(names(page)).toHaveText(["My first crocus", "Riesling 2", "Riesling"]);
	await expect(cards(page).locator("canvas")).toHaveCount(3);
	await expect(cards(page).first().locator(".about")).toHaveText(/^Flower\s*\d+ \w+ \d{4}$/);
	const search = dialog(page).getByRole("searchbox", { name: "Search my plants" });
	await search.fill("ries");
	await expect(names(page)).toHaveText(["Riesling 2", "Riesling"]);
	await expect(dialog(page).locator(".found")).toHaveText("2 of 3 plants");
	await dialog(page).getByRole("combobox", { name: "Order" }).selectOption("By name");
	await expect(names(page)).toHaveText(["Riesling", "Riesling 2"]);

	// By keys alone: one stop of the Tab key, then arrows, F2, Delete, and Ctrl+Z.
	await dialog(page).getByRole("combobox", { name: "Order" }).press("Tab");
	await expect(dialog(page).getByRole("checkbox", { name: "Select all" })).toBeFocused();
	await page.keyboard.press("Tab");
	await expect(inDialog(page, "Open Riesling")).toBeFocused();
	await page.keyboard.press("ArrowRight");
	await page.keyboard.press("F2");
	await expect(dialog(page).getByLabel("New name of Riesling 2")).toBeFocused();
	await page.keyboard.type("Twin ries");
	await page.keyboard.press("Enter");
	await expect(status(page)).toHaveText("Renamed “Riesling 2” to “Twin ries”.");
	await expect(inDialog(page, "Open Twin ries")).toBeFocused();
	await page.keyboard.press("F2");
	await page.keyboard.type("No");
	await page.keyboard.press("Escape");
	await expect(names(page)).toHaveText(["Riesling", "Twin ries"]);
	await page.keyboard.press("Delete");
	await expect(names(page)).toHaveText(["Riesling"]);
	await expect(inDialog(page, "Open Riesling")).toBeFocused();
	await page.keyboard.press("Control+z");
	await expect(status(page)).toHaveText("Restored “Twin ries”.");
	await expect(inDialog(page, "Open Twin ries")).toBeFocused();
	await inDialog(page, "Delete Twin ries").click();
	await inDialog(page, "Undo deleting “Twin ries”").click();
	await expect(names(page)).toHaveText(["Riesling", "Twin ries"]);

	// Opening is one step, as choosing a preset is; the plant is the one that was saved.
	await studio.regrown(() => inDialog(page, "Open Twin ries").click());
	await expect(dialog(page)).toBeHidden();
	await expect(studio.fingerprint).toHaveText(riesling);
	await expect(page).toHaveURL(/preset=riesling&seed=4/);
	await studio.button("Undo").click();
	await expect(studio.fingerprint).toHaveText(duku);
	await expect(studio.notices.locator(".notice")).toHaveCount(0);
});

test("several are selected by hand, by a range or by a search, deleted as one step and brought back; an import is undone", async ({
	page,
}) => {
	await new StudioPage(page).open("?v=2&preset=lychee");
	await openSaved(page);
	await imported(page, "many.panicle.json", libraryOf(7));
	await expect(status(page)).toHaveText("Plants imported: 7.");
	const select = (name: string) => dialog(page).getByRole("checkbox", { name, exact: true });
	const selected = dialog(page).getByRole("group", { name: "Selection" });
	await select("Select Vine 6").click();
	await select("Select Vine 3").click({ modifiers: ["Shift"] });
	await expect(selected).toContainText("4 selected");
	await select("Select Vine 5").click();
	await inDialog(page, "Delete 3").click();
	await expect(status(page)).toHaveText("Deleted 3 plants.");
	await expect(names(page)).toHaveText(["Vine 5", "Vine 2", "Vine 1", "Vine 0"]);
	await inDialog(page, "Undo deleting 3 plants").click();
	await expect(status(page)).toHaveText("Restored 3 plants.");
	await expect(inDialog(page, "Open Vine 6")).toBeFocused();
	await expect(names(page)).toHaveCount(7);

	// Items outside the search result are not deleted with it.
	await select("Select all").click();
	await expect(selected).toContainText("7 selected");
	await dialog(page).getByRole("searchbox", { name: "Search my plants" }).fill("vine 1");
	await expect(selected).toContainText("1 selected");
	await inDialog(page, "Open Vine 1").focus();
	await page.keyboard.press("Delete");
	await expect(status(page)).toHaveText("Deleted “Vine 1”.");
	await dialog(page).getByRole("searchbox", { name: "Search my plants" }).fill("");
	await expect(names(page)).toHaveCount(6);

	// By keys alone: everything, and both steps back.
	await inDialog(page, "Open Vine 2").focus();
	await page.keyboard.press("Control+a");
	await expect(selected).toContainText("6 selected");
	await page.keyboard.press("Delete");
	await expect(dialog(page)).toContainText("No saved plants yet.");
	await inDialog(page, "Undo deleting 6 plants").click();
	await inDialog(page, "Undo deleting “Vine 1”").click();
	await inDialog(page, "Undo importing 7 plants").click();
	await expect(status(page)).toHaveText("Undid the import and removed 7 plants.");
	await expect(cards(page)).toHaveCount(0);
	await expect(dialog(page).getByRole("button", { name: /^Undo/ })).toHaveCount(0);
});

test("of 10,000 specimens only those in sight are in the page, and keys, search and screen readers reach all of them", async ({
	page,
}) => {
	await new StudioPage(page).open("?v=2&preset=lychee");
	await openSaved(page);
	await imported(page, "many.panicle.json", libraryOf(10_000));
	await expect(status(page)).toHaveText("Plants imported: 10,000.");
	const size = () => dialog(page).evaluate((element) => element.querySelectorAll("*").length);
	expect(await size()).toBeLessThan(1500);
	const item = (name: string) =>
		dialog(page)
			.getByRole("listitem")
			.filter({ hasText: new RegExp(`^\\s*${name}\\s`) });
	await expect(item("Vine 9999")).toHaveAttribute("aria-posinset", "1");
	await expect(item("Vine 9999")).toHaveAttribute("aria-setsize", "10000");

	// The focus goes to cards that were not in the page, and stays where the list is scrolled away from it.
	await inDialog(page, "Open Vine 9999").focus();
	await page.keyboard.press("End");
	await expect(inDialog(page, "Open Vine 0")).toBeFocused();
	await expect(inDialog(page, "Open Vine 0")).toBeInViewport();
	await expect(item("Vine 0")).toHaveAttribute("aria-posinset", "10000");
	await dialog(page).evaluate((element) => element.scrollTo(0, 0));
	await expect(inDialog(page, "Open Vine 9999")).toBeInViewport();
	await expect(inDialog(page, "Open Vine 0")).toBeFocused();
	expect(await size()).toBeLessThan(1500);
	await page.keyboard.press("ArrowLeft");
	await expect(inDialog(page, "Open Vine 1")).toBeFocused();
	await expect(inDialog(page, "Open Vine 1")).toBeInViewport();
	await page.keyboard.press("Home");
	await page.keyboard.press("ArrowDown");
	await expect(dialog(page).locator("[data-saved]:focus-within")).toHaveAttribute("aria-posinset", /^[2-9]$/);

	await dialog(page).getByRole("searchbox", { name: "Search my plants" }).fill("vine 4321");
	await expect(names(page)).toHaveText(["Vine 4321"]);
	await expect(cards(page)).toHaveAttribute("aria-setsize", "1");
});

test("everything goes into one file and comes back out of it, once; what cannot be used is said with its place", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	await openSaved(page);
	await save(page);
	await save(page, "<img src=x onerror=alert(1)>");
	const text = await exported(page);
	await imported(page, "again.json", text);
	await expect(status(page)).toHaveText("Nothing was imported: all 2 plants are already here.");
	await imported(page, "cut.panicle.json", text.slice(0, -9));
	await expect(status(page)).toContainText("cut.panicle.json was not imported.");
	await expect(status(page)).toContainText("is damaged or incomplete.");
	await imported(page, "plant.json", '{"specimen":{"preset":"duku"}}');
	await expect(status(page)).toContainText("plant.json is a single plant. Use Open… for it.");
	await page.keyboard.press("Escape");
	await forget(page);

	// Dropped on the page as any file, with worse in it.
	const document = JSON.parse(text);
	document.specimens.push(
		{ name: "No link" },
		{
			...document.specimens[0],
			name: "Changed",
			saved: "2020-02-03T04:05:06Z",
			link: "?v=1&preset=grape-15b",
			fingerprint: "0123456789abcdef",
			picture: "data:image/svg+xml,<svg/>",
		},
	);
	await studio.drop("mine.panicle.json", Buffer.from(JSON.stringify(document)));
	await expect(status(page)).toContainText("Plants imported: 3.");
	await expect(status(page)).toContainText("No. 3, “No link”: The link is not text. This plant was skipped.");
	await expect(status(page)).toContainText(
		"No. 4, “Changed”: The picture is not a JPEG. This plant was imported without a picture.",
	);
	await expect(names(page)).toHaveText(["<img src=x onerror=alert(1)>", "Lychee", "Changed"]);

	// A plant that differs from the file's fingerprint is opened with a message.
	await studio.regrown(() => inDialog(page, "Open Changed").click());
	await expect(studio.notices).toContainText("“Changed” no longer matches the saved plant");
	await expect(studio.notices).toContainText("fingerprint 0123456789abcdef");
});

test("two tabs see what the other does, and a later version in one is no harm to the other", { tag: "@long" }, async ({
	page,
	context,
	complaints,
}) => {
	await new StudioPage(page).open("?v=2&preset=lychee");
	const second = await context.newPage();
	complaints.listenTo(second);
	await new StudioPage(second).open("?v=2&preset=duku");
	await openSaved(page);
	await openSaved(second);
	await save(page);
	await expect(names(second)).toHaveText(["Lychee"]);
	await inDialog(second, "Delete Lychee").click();
	await expect(cards(page)).toHaveCount(0);
	await inDialog(second, "Undo deleting “Lychee”").click();
	await expect(names(page)).toHaveText(["Lychee"]);

	// Later versions need not wait for this one to let go.
	await second.evaluate(
		() =>
			new Promise<void>((resolve, reject) => {
				const request = indexedDB.open("panicle.saved", 3);
				request.onsuccess = () => resolve(request.result.close());
				request.onblocked = () => reject(new Error("blocked"));
			}),
	);
	await inDialog(page, /^Save this/).click();
	await expect(dialog(page).getByRole("alert")).toContainText("A newer version of Panicle in another tab");
	await expect(names(page)).toHaveText(["Lychee 2", "Lychee"]);
	await expect(cards(page).first()).toContainText("not stored");
});

test("plants that do not fit on a full disk are reported, can be exported, and are stored when there is room", {
	tag: "@long",
}, async ({ page }) => {
	await new StudioPage(page).open("?v=2&preset=lychee");
	await openSaved(page);
	await save(page);
	await fill(page, true);
	await inDialog(page, /^Save this/).click();
	const alert = dialog(page).getByRole("alert");
	await expect(alert).toContainText("Browser storage is full.");
	await expect(status(page)).toHaveText(/^\s*This plant is already saved as “Lychee/);
	await expect(alert).toContainText("“Lychee 2” could not be stored and will be lost");
	await expect(names(page)).toHaveText(["Lychee 2", "Lychee"]);
	const text = await exported(page, "Export unsaved plants");
	expect(JSON.parse(text).specimens.map(({ name }: { name: string }) => name)).toEqual(["Lychee 2"]);
	// Leaving the page requires a confirmation.
	const confirmation = page.waitForEvent("dialog");
	const closing = page.close({ runBeforeUnload: true });
	const question = await confirmation;
	expect(question.type()).toBe("beforeunload");
	await question.dismiss();
	await closing;
	await fill(page, false);
	await inDialog(page, "Try again").click();
	await expect(alert).toHaveCount(0);
	await page.reload();
	await openSaved(page);
	await expect(names(page)).toHaveText(["Lychee 2", "Lychee"]);
});

test("a browser that keeps nothing says so before anything is saved", { tag: "@long" }, async ({ page }) => {
	await page.addInitScript(() => {
		IDBFactory.prototype.open = () => {
			throw new DOMException("no", "SecurityError");
		};
	});
	await page.setViewportSize({ width: 390, height: 844 });
	const studio = await new StudioPage(page).open("?v=2&preset=lychee");
	await openSaved(page);
	await expect(dialog(page).getByRole("alert")).toContainText("Your browser does not let this page store data");
	await inDialog(page, /^Save this/).click();
	await expect(names(page)).toHaveText(["Lychee"]);
	await expect(cards(page)).toContainText("not stored");
	expect(await studio.overflow()).toBeLessThanOrEqual(0);
	const sideways = await dialog(page).evaluate((element) => element.scrollWidth - element.clientWidth);
	expect(sideways).toBeLessThanOrEqual(0);
});
