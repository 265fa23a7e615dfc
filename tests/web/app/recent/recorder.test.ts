import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Recents } from "../../../../web/src/app/recent/recents";
import { RecentRecorder } from "../../../../web/src/app/recent/recorder";
import type { Studio } from "../../../../web/src/app/studio";
import type { PageModel } from "../../../../web/src/models/page_model";
import type { Plant } from "../../../../web/src/plant/plant";
import { specimenFromPreset } from "../../bunch";
import { toy } from "../../toy";
import { bunchModel, studioWith } from "../context";
import { MemoryStorage, SharedRecent } from "./recent_store";

const toyModel = toy as unknown as PageModel;
const picture = Uint8Array.of(1);
const REST = 20;

describe("the recorder of recent plants", () => {
	let studio: Studio;
	let store: SharedRecent;
	let storage: MemoryStorage;
	let recorder: RecentRecorder;
	const thumbnail = vi.fn(async () => picture);
	let stop: () => void;

	const grow = () => {
		studio.grew({} as Plant, studio.state.specimen);
		studio.caughtUp();
	};
	const links = () => store.plants.map(({ link }) => link);
	const listed = (...expected: string[]) => vi.waitFor(() => expect(links()).toEqual(expected));
	const rest = () => new Promise((resolve) => setTimeout(resolve, 4 * REST));
	const start = () => {
		recorder = new RecentRecorder(studio, new Recents(store, storage), { thumbnail, rest: REST });
		stop = recorder.start();
	};

	beforeEach(async () => {
		({ studio } = await studioWith(specimenFromPreset("riesling")));
		studio.showPicture(async () => new Blob());
		store = new SharedRecent();
		storage = new MemoryStorage();
		thumbnail.mockClear();
		start();
	});
	afterEach(() => stop());

	it("records a plant that is looked at, and updates its entry with every edit", async () => {
		grow();
		await listed("?v=2&preset=riesling");
		expect(store.plants[0]).toMatchObject({ title: "Riesling" });
		expect(store.plants[0].editedAt).toBeUndefined();
		studio.set({ parameters: { l: 400 } });
		grow();
		await listed("?v=2&preset=riesling&l=400");
		expect(store.plants[0]).toMatchObject({ title: "Riesling (edited)", editedAt: expect.any(Number) });
		await vi.waitFor(() => expect(store.contents.get(store.plants[0].id)?.picture).toBe(picture));
	});

	it("records no step of a drag, and one entry for many edits in a row", async () => {
		grow();
		const change = vi.spyOn(store, "change");
		for (const l of [400, 410, 420]) studio.edit({ parameters: { l } });
		await rest();
		expect(links()).not.toContain("?v=2&preset=riesling&l=420");
		studio.settle();
		for (const l of [430, 440]) studio.set({ parameters: { l } });
		grow();
		await listed("?v=2&preset=riesling&l=440");
		expect(change.mock.calls.length).toBeLessThanOrEqual(3);
	});

	it("records a plant that grows for long at once, and its picture when it has grown", async () => {
		studio.set({ parameters: { l: 400 } });
		await listed("?v=2&preset=riesling&l=400");
		expect(thumbnail).not.toHaveBeenCalled();
		grow();
		await vi.waitFor(() => expect(store.contents.get(store.plants[0].id)?.picture).toBe(picture));
	});

	it("makes a new entry for each plant that is opened, also of the same preset, and continues one by Undo", async () => {
		grow();
		studio.set({ parameters: { l: 400 } });
		await listed("?v=2&preset=riesling&l=400");
		studio.choosePreset("riesling");
		await listed("?v=2&preset=riesling", "?v=2&preset=riesling&l=400");
		studio.choosePreset("plain", toyModel);
		await listed("?v=2&model=toy", "?v=2&preset=riesling", "?v=2&preset=riesling&l=400");
		const saved = { ...specimenFromPreset("lychee"), seed: 7 };
		studio.take(bunchModel, { specimen: saved, notes: [] }, "file");
		await vi.waitFor(() => expect(links()).toHaveLength(4));
		for (let step = 0; step < 3; step++) studio.undo();
		studio.set({ parameters: { l: 410 } });
		await vi.waitFor(() => expect(links()[0]).toBe("?v=2&preset=riesling&l=410"));
		expect(links()).toHaveLength(4);
		expect(links()).not.toContain("?v=2&preset=riesling&l=400");
	});

	it("continues the entry of a plant that is opened again, in another page", async () => {
		studio.set({ parameters: { l: 400 } });
		grow();
		await listed("?v=2&preset=riesling&l=400");
		const [{ editedAt }] = store.plants;
		stop();
		({ studio } = await studioWith(studio.state.specimen));
		start();
		grow();
		await vi.waitFor(() => expect(store.plants[0].at).toBeGreaterThan(editedAt as number));
		expect(store.plants).toMatchObject([{ link: "?v=2&preset=riesling&l=400", editedAt }]);
		studio.set({ parameters: { l: 410 } });
		await listed("?v=2&preset=riesling&l=410");
	});

	it("does not count a preset as edited once its edits are undone", async () => {
		studio.set({ parameters: { l: 400 } });
		await listed("?v=2&preset=riesling&l=400");
		studio.undo();
		await listed("?v=2&preset=riesling");
		expect(store.plants[0].editedAt).toBeUndefined();
	});

	it("does not count the play of a life as an edit", async () => {
		grow();
		const [running] = studio.state.modelUi?.tools.flatMap(({ bar, parameters = [] }) => (bar ? parameters : [])) ?? [];
		studio.edit({ parameters: { [running]: 50 } }, "life");
		studio.settle();
		await vi.waitFor(() => expect(links()[0]).toContain(`${running}=50`));
		expect(store.plants[0].editedAt).toBeUndefined();
		expect(store.plants[0].title).toBe("Riesling");
	});

	it("stores the newest state when the page is hidden, and at once when it is left", async () => {
		grow();
		await listed("?v=2&preset=riesling");
		studio.set({ parameters: { l: 400 } });
		await recorder.flush();
		expect(links()).toEqual(["?v=2&preset=riesling&l=400"]);
		studio.set({ parameters: { l: 410 } });
		// The link is encoded within the same task.
		await Promise.resolve();
		await Promise.resolve();
		await Promise.resolve();
		recorder.defer();
		stop();
		expect(storage.getItem("panicle.recent")).toContain("l=410");
		expect((await new Recents(store, storage).all()).map(({ link }) => link)).toEqual(["?v=2&preset=riesling&l=410"]);
	});

	it("goes on without the list where storage is forbidden or the browser makes no picture", async () => {
		thumbnail.mockRejectedValueOnce(new Error("no picture"));
		studio.set({ parameters: { l: 400 } });
		grow();
		await listed("?v=2&preset=riesling&l=400");
		store.forbidden = new DOMException("no", "SecurityError");
		studio.set({ parameters: { l: 410 } });
		grow();
		await rest();
		await recorder.flush();
		store.forbidden = undefined;
		await recorder.flush();
		expect(links()).toEqual(["?v=2&preset=riesling&l=410"]);
	});
});
