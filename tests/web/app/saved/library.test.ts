import { describe, expect, it, vi } from "vitest";
import { Library, type Tabs } from "../../../../web/src/app/saved/library";
import { SharedStore, savedAs } from "./saved_store";

const namesOf = (library: Library) => library.all.map(({ name }) => name).sort();

/** Two tabs of one browser, which exchange messages. */
function twoTabs() {
	const store = new SharedStore();
	const tabs: Tabs[] = [];
	const tab = () => {
		const own: Tabs = {
			onmessage: null,
			postMessage: () => {
				for (const other of tabs) if (other !== own) other.onmessage?.({} as MessageEvent);
			},
		};
		tabs.push(own);
		return new Library(store, own);
	};
	return { store, one: tab(), other: tab() };
}

describe("a library", () => {
	it("adds each specimen under a unique name, and reads it again", async () => {
		const { store, one } = twoTabs();
		for (const name of ["Merlot", "Merlot", "Merlot 2"]) await one.add(savedAs(name));
		expect(namesOf(one)).toEqual(["Merlot", "Merlot 2", "Merlot 2 2"]);
		const later = new Library(store);
		expect(later.all).toEqual([]);
		await later.read();
		expect(namesOf(later)).toEqual(namesOf(one));
	});

	it("combines concurrent changes of two tabs, and shows them in both", async () => {
		const { store, one, other } = twoTabs();
		const first = await one.add(savedAs("First"));
		const second = await one.add(savedAs("Second"));
		await other.read();
		await Promise.all([
			one.add(savedAs("Merlot")),
			other.add(savedAs("Merlot")),
			one.rename(first.id, "Renamed"),
			other.remove([second.id]),
			one.bring([savedAs("Brought", { link: "?v=1" })]),
			other.bring([savedAs("Brought", { link: "?v=1" })]),
		]);
		const names = ["Brought", "Merlot", "Merlot 2", "Renamed"];
		expect(store.stored.map(({ name }) => name).sort()).toEqual(names);
		await vi.waitFor(() => {
			expect(namesOf(one)).toEqual(names);
			expect(namesOf(other)).toEqual(names);
		});
	});

	it("does not restore a specimen deleted in another tab by renaming it", async () => {
		const { store, one } = twoTabs();
		const { id } = await one.add(savedAs("Merlot"));
		// Before this tab has heard of it.
		await store.change(() => ({ remove: [id] }));
		await one.rename(id, "Syrah");
		expect([namesOf(one), store.stored]).toEqual([[], []]);
	});

	it("restores deleted specimens unchanged, the last deletion first", async () => {
		const { one } = twoTabs();
		const merlot = await one.add(savedAs("Merlot", { fingerprint: "0123456789abcdef" }));
		const syrah = await one.add(savedAs("Syrah"));
		await one.remove([merlot.id]);
		await one.remove([syrah.id]);
		expect([one.all, one.lastStep]).toEqual([[], { kind: "deletion", specimens: [syrah] }]);
		await one.undo();
		expect(await one.undo()).toEqual({ kind: "deletion", specimens: [merlot] });
		expect(await one.undo()).toBeUndefined();
		expect(namesOf(one)).toEqual(["Merlot", "Syrah"]);
	});

	it("deletes several in one step of the store, and restores them with their pictures", async () => {
		const { store, one } = twoTabs();
		const several = Array.from({ length: 1200 }, (_, index) =>
			savedAs(`Vine ${index}`, { link: `?v=2&seed=${index}`, picture: Uint8Array.of(index % 256) }),
		);
		await one.bring(several);
		// In another tab, before this one has heard of it: that deletion is not this one's to undo.
		await store.change(() => ({ remove: [several[7].id] }));
		const change = vi.spyOn(store, "change");
		const ids = several.slice(0, 1000).map(({ id }) => id);
		expect(await one.remove(ids)).toHaveLength(999);
		expect([one.all.length, store.pictureOf.size, change.mock.calls.length]).toEqual([200, 200, 1]);
		expect(one.lastStep).toMatchObject({ kind: "deletion", specimens: { length: 999 } });
		await one.undo();
		expect([one.all.length, store.pictureOf.size, change.mock.calls.length]).toEqual([1199, 1199, 2]);
		expect(store.pictureOf.get(several[300].id)).toEqual(several[300].picture);
	});

	it("undoes an import: deletes the imported specimens only", async () => {
		const { one } = twoTabs();
		const own = await one.add(savedAs("Own", { link: "?v=2&seed=1" }));
		await one.bring([savedAs("Own", { link: "?v=2&seed=1" }), savedAs("Brought"), savedAs("Gone")]);
		const later = await one.add(savedAs("Later"));
		await one.rename(one.all.find(({ name }) => name === "Brought")?.id ?? "", "Renamed");
		await one.remove(one.all.flatMap(({ id, name }) => (name === "Gone" ? id : [])));
		expect(await one.undo()).toMatchObject({ kind: "deletion", specimens: [{ name: "Gone" }] });
		expect(one.lastStep).toMatchObject({ kind: "import", specimens: { length: 2 } });
		expect(await one.undo()).toMatchObject({ kind: "import", specimens: { length: 2 } });
		expect(one.all).toEqual([own, later]);
		expect(await one.undo()).toBeUndefined();
	});

	it("can undo an import later if the store fails", async () => {
		const { store, one } = twoTabs();
		await one.bring([savedAs("Brought")]);
		vi.spyOn(store, "change").mockRejectedValueOnce(new Error("No shelf."));
		expect(await one.undo()).toBeUndefined();
		expect([namesOf(one), one.trouble]).toEqual([["Brought"], "No shelf."]);
		await one.undo();
		expect([namesOf(one), one.lastStep]).toEqual([[], undefined]);
	});

	it("imports the specimens of a file that are new by name and link, duplicates once", async () => {
		const { one } = twoTabs();
		await one.add(savedAs("Merlot", { link: "?v=2&preset=merlot" }));
		const file = [
			savedAs("Merlot", { link: "?v=2&preset=merlot" }),
			savedAs("Merlot", { link: "?v=2&preset=merlot&seed=2" }),
			savedAs("Other", { link: "?v=2&preset=merlot" }),
			savedAs("Other", { link: "?v=2&preset=merlot" }),
		];
		expect(await one.bring(file)).toBe(2);
		expect(await one.bring(file)).toBe(0);
		expect(namesOf(one)).toEqual(["Merlot", "Merlot", "Other"]);
	});

	it("reports specimens that could not be stored and retains them until they are", async () => {
		const { store, one } = twoTabs();
		const first = await one.add(savedAs("First"));
		store.full = "The disk is full.";
		const unstored = await one.add(savedAs("First"));
		await one.rename(first.id, "Renamed");
		await one.bring([savedAs("Brought")]);
		expect(one.trouble).toBe("The disk is full.");
		expect(namesOf(one)).toEqual(["Brought", "First 2", "Renamed"]);
		expect(one.unstored.map(({ name }) => name).sort()).toEqual(["Brought", "First 2", "Renamed"]);
		expect(store.stored).toEqual([first]);
		await one.keep();
		expect(one.isStored(unstored)).toBe(false);
		// Reading again does not change specimens that are not stored.
		await one.read();
		expect(namesOf(one)).toEqual(["Brought", "First 2", "Renamed"]);
		store.full = undefined;
		await one.keep();
		expect([one.unstored, one.trouble]).toEqual([[], undefined]);
		expect(store.stored.map(({ name }) => name).sort()).toEqual(["Brought", "First 2", "Renamed"]);
	});

	it("deletes specimens that were never stored without the store; those that it cannot delete stay", async () => {
		const { store, one } = twoTabs();
		const stored = await one.add(savedAs("Kept"));
		store.full = "The disk is full.";
		const unstored = await one.add(savedAs("Unkept"));
		vi.spyOn(store, "change").mockRejectedValue(new Error("No shelf."));
		await one.remove([unstored.id]);
		await one.remove([stored.id]);
		expect(namesOf(one)).toEqual(["Kept"]);
		expect(one.trouble).toBe("No shelf.");
		expect(one.lastStep).toEqual({ kind: "deletion", specimens: [unstored] });
	});

	it("reads a picture only to show, export or delete it, and restores it with its specimen", async () => {
		const { store, one, other } = twoTabs();
		const picture = (byte: number) => Uint8Array.of(byte, byte);
		const merlot = await one.add(savedAs("Merlot", { picture: picture(1) }));
		const syrah = await one.add(savedAs("Syrah", { picture: picture(2) }));
		await one.rename(merlot.id, "Malbec");
		await other.read();
		await other.rename(syrah.id, "Shiraz");
		expect(store.readPictures).toEqual([]);
		expect([...one.all, ...other.all].some((saved) => saved.picture)).toBe(false);
		const exported = await other.withPictures(other.all);
		expect(exported.map((saved) => [saved.name, saved.picture?.[0]]).sort()).toEqual([
			["Malbec", 1],
			["Shiraz", 2],
		]);
		await one.remove([merlot.id]);
		expect(store.pictureOf.has(merlot.id)).toBe(false);
		await one.undo();
		expect(store.pictureOf.get(merlot.id)).toEqual(picture(1));
	});

	it("shows and exports the picture of a specimen renamed while the store is full", async () => {
		const { store, one } = twoTabs();
		const { id } = await one.add(savedAs("Merlot", { picture: Uint8Array.of(7) }));
		store.full = "The disk is full.";
		await one.rename(id, "Malbec");
		expect((await one.withPictures(one.unstored))[0]).toMatchObject({ name: "Malbec", picture: Uint8Array.of(7) });
		vi.spyOn(store, "pictures").mockRejectedValue(new Error("No shelf."));
		expect((await one.withPictures(one.unstored))[0].name).toBe("Malbec");
	});

	it("notifies listeners of every change", async () => {
		const { one, other } = twoTabs();
		const heard = vi.fn();
		const end = other.subscribe(heard);
		await one.add(savedAs("Merlot"));
		await vi.waitFor(() => expect(heard).toHaveBeenCalled());
		expect(namesOf(other)).toEqual(["Merlot"]);
		end();
		heard.mockClear();
		await other.remove([other.all[0].id]);
		expect(heard).not.toHaveBeenCalled();
	});
});
