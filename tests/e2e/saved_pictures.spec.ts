import { expect, test } from "./fixtures";
import { cards, exported, inDialog, openSaved, save, status } from "./saved_page";
import { StudioPage } from "./studio_page";

test("pictures of the first layout are kept, apart from the records, and a rename reads none", {
	tag: "@long",
}, async ({ page }) => {
	await new StudioPage(page).open("?v=2&preset=lychee");
	await openSaved(page);
	await save(page);
	await page.keyboard.press("Escape");
	// As a former version of the page left it: pictures within the records.
	const letters = await page.evaluate(async () => {
		const done = <T>(request: IDBRequest<T>) =>
			new Promise<T>((resolve, reject) => {
				request.onsuccess = () => resolve(request.result);
				request.onerror = () => reject(request.error);
			});
		const before = await done(indexedDB.open("panicle.saved"));
		const from = before.transaction(["specimens", "pictures"]);
		const [record] = await done(from.objectStore("specimens").getAll());
		const picture = await done(from.objectStore("pictures").get(record.id));
		before.close();
		await done(indexedDB.deleteDatabase("panicle.saved"));
		const opening = indexedDB.open("panicle.saved", 1);
		opening.onupgradeneeded = () => opening.result.createObjectStore("specimens", { keyPath: "id" });
		const database = await done(opening);
		const store = database.transaction("specimens", "readwrite").objectStore("specimens");
		for (let i = 0; i < 5; i++) await done(store.put({ ...record, id: `id ${i}`, name: `Lychee ${i}`, picture }));
		database.close();
		return [Object.hasOwn(record, "picture"), picture.length];
	});
	expect(letters[0]).toBe(false);
	expect(letters[1]).toBeGreaterThan(1000);
	await page.addInitScript(() => {
		const read: string[] = [];
		Object.assign(window, { storesRead: read });
		for (const name of ["get", "getAll"] as const) {
			const whole = IDBObjectStore.prototype[name] as (...of: unknown[]) => IDBRequest;
			IDBObjectStore.prototype[name] = function (this: IDBObjectStore, ...of: unknown[]) {
				read.push(this.name);
				return whole.apply(this, of);
			};
		}
	});
	await page.reload();
	await openSaved(page);
	await expect(cards(page).locator("canvas")).toHaveCount(5);
	await page.evaluate(() => Reflect.get(window, "storesRead").splice(0));
	await inDialog(page, "Rename Lychee 3").click();
	await page.keyboard.type("Litchi");
	await page.keyboard.press("Enter");
	await expect(status(page)).toHaveText("“Lychee 3” is “Litchi” now.");
	expect(await page.evaluate(() => Reflect.get(window, "storesRead"))).toEqual(["specimens"]);
	await expect(cards(page).locator("canvas")).toHaveCount(5);
	const { specimens } = JSON.parse(await exported(page));
	expect(specimens.every(({ picture }: { picture?: string }) => picture?.startsWith("data:image/jpeg;"))).toBe(true);
});
