import { beforeEach, describe, expect, it } from "vitest";
import { Recents } from "../../../../web/src/app/recent/recents";
import { MemoryStorage, plantAs, SharedRecent } from "./recent_store";

const picture = Uint8Array.of(0xff, 0xd8);
const quota = new DOMException("full", "QuotaExceededError");

describe("recent plants in the browser", () => {
	let store: SharedRecent;
	let storage: MemoryStorage;
	let recents: Recents;
	const ids = async () => (await recents.all()).map(({ id }) => id);

	beforeEach(() => {
		store = new SharedRecent();
		storage = new MemoryStorage();
		recents = new Recents(store, storage);
	});

	it("are recorded with their contents, of which a later record may leave parts as they are", async () => {
		await recents.record(plantAs("a"), { picture, extra: "{}" });
		await recents.record(plantAs("a", { at: 2000 }), { extra: "{}" });
		expect(await recents.all()).toEqual([plantAs("a", { at: 2000, extra: "stored" })]);
		expect(await recents.content("a")).toEqual({ picture, extra: "{}" });
	});

	it("of two pages that write at the same time are all stored", async () => {
		const other = new Recents(store, storage);
		const [mine, theirs] = [plantAs("a", { at: 1 }), plantAs("b", { at: 2 })];
		await Promise.all([recents.record(mine, {}), other.record(theirs, {})]);
		expect(await ids()).toEqual(["b", "a"]);
	});

	it("take over the picture of the entry that they replace", async () => {
		await recents.record(plantAs("a"), { picture });
		await recents.record(plantAs("b", { link: plantAs("a").link, at: 2000 }), {});
		expect(await ids()).toEqual(["b"]);
		expect((await recents.content("b")).picture).toBe(picture);
	});

	it("are stored without picture and extra fields on a full disk, and marked as incomplete", async () => {
		store.full = quota;
		await recents.record(plantAs("a"), { picture, extra: "{}" });
		await recents.record(plantAs("b", { at: 2000 }), { picture });
		expect(await recents.all()).toEqual([plantAs("b", { at: 2000 }), plantAs("a", { extra: "missing" })]);
	});

	it("are none, without an error, where storage is forbidden", async () => {
		store.forbidden = new DOMException("no", "SecurityError");
		storage.most = -1;
		await expect(recents.record(plantAs("a"), {})).rejects.toThrow("no");
		recents.defer(plantAs("a"));
		expect(await recents.all()).toEqual([]);
		expect(await recents.content("a")).toEqual({});
		expect(await recents.remove(["a"])).toEqual([]);
		await recents.restore([{ plant: plantAs("a"), content: {} }]);
	});

	it("of a page that is left are added by the next page, unless a newer state is stored", async () => {
		await recents.record(plantAs("a", { at: 2000 }), { picture });
		recents.defer(plantAs("a", { at: 1500, title: "older" }));
		recents.defer(plantAs("b", { at: 3000 }));
		recents.defer(plantAs("c", { at: 1000 }));
		const next = new Recents(store, storage);
		expect(await next.all()).toEqual([plantAs("b", { at: 3000 }), plantAs("a", { at: 2000 }), plantAs("c")]);
		store.plants = [];
		expect(await next.all()).toEqual([]);
	});

	it("ignore foreign data of pages that were left", async () => {
		for (const text of ["{", "7", '{"length":9}', '[null,{"id":"a"}]', `[${JSON.stringify(plantAs("a"))},4]`]) {
			store.plants = [];
			storage.setItem("panicle.recent", text);
			expect(await ids()).toEqual(text.includes("link") ? ["a"] : []);
		}
	});

	it("are removed, and restored with their contents", async () => {
		await recents.record(plantAs("a"), { picture });
		await recents.record(plantAs("b", { at: 2000 }), {});
		const removed = await recents.remove(["a", "b", "none"]);
		expect(await ids()).toEqual([]);
		expect(store.contents.size).toBe(0);
		await recents.record(plantAs("c", { at: 1500 }), {});
		await recents.restore(removed);
		expect(await ids()).toEqual(["b", "c", "a"]);
		expect((await recents.content("a")).picture).toBe(picture);
	});
});
