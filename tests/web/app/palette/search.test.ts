import { beforeAll, describe, expect, it, vi } from "vitest";
import { actionEntries, settingEntries, toolEntries } from "../../../../web/src/app/palette/entries";
import { MAX_RECENT, recentKeys, rememberKey } from "../../../../web/src/app/palette/recent";
import { recentPlantEntries } from "../../../../web/src/app/palette/recent_plants";
import { entriesToStart, findEntries, indexOf } from "../../../../web/src/app/palette/search";
import type { Studio } from "../../../../web/src/app/studio";
import { modelNamed, modelNames } from "../../../../web/src/models/index";
import { encodeLink } from "../../../../web/src/specimen/link";
import { specimenFromPreset } from "../../bunch";
import { studioWith } from "../context";

vi.mock("../../../../web/src/app/parts/open_part", () => ({ openPart: vi.fn() }));

describe("the command palette", () => {
	let studio: Studio;
	beforeAll(async () => {
		({ studio } = await studioWith(specimenFromPreset()));
		studio.list(await Promise.all(modelNames().map((name) => modelNamed(name))));
	});
	const entries = () => [...actionEntries(studio), ...toolEntries(studio), ...settingEntries(studio)];
	const find = (query: string) => findEntries(studio, indexOf(entries()), query);
	const first = (query: string) => find(query)[0]?.entries[0]?.key;

	it.each([
		["riesling", "plant:bunch/riesling"],
		["conifers", "plant:growth/spruce"],
		["figure 11", "plant:bunch/long-conical"],
		["length", "setting:bunch/l"],
		["lenght", "setting:bunch/l"],
		["new var", "action:variation"],
		["shuffle", "action:variation"],
		["dark mode", "action:theme"],
		["share", "action:share"],
		["url", "action:link"],
		["hotkeys", "action:shortcuts"],
		["manual", "action:help"],
		["copy lnik", "action:link"],
		["grammar", "tool:bunch/grammar"],
		["branching", "group:bunch/branching"],
	])("finds for %j first %s", (query, key) => expect(first(query)).toBe(key));

	it("lists the group with the best match first, each with its heading, and few of each", () => {
		expect(find("age").map(({ group }) => group)[0]).toBe("settings");
		const groups = find("berry");
		expect(groups.map(({ group }) => group)).toContain("plants");
		for (const { entries: own } of groups) expect(own.length).toBeLessThanOrEqual(8);
		expect(find("plum pudding")).toEqual([]);
	});

	it("takes typos only where no group has a match", () => {
		expect(find("pine").map(({ group }) => group)).toEqual(["plants"]);
		expect(find("lenght").map(({ group }) => group)).toContain("settings");
	});

	it("runs a plant as one undo step", () => {
		const before = studio.state.specimen;
		find("lychee")[0].entries[0].run();
		expect(studio.state.specimen.preset).toBe("lychee");
		studio.undo();
		expect(studio.state.specimen).toBe(before);
	});

	it("offers only actions that can be run, and never itself", () => {
		const keys = () => actionEntries(studio).map(({ key }) => key);
		expect(keys()).not.toContain("action:palette");
		expect(keys()).not.toContain("action:wind"); // There is no view.
		expect(keys()).toContain("action:redo");
		studio.newVariation();
		expect(keys()).not.toContain("action:redo");
		expect(keys()).toContain("action:undo");
	});

	it("shows values as the controls do, and keys only while they work", () => {
		const about = (key: string) => entries().find((entry) => entry.key === key);
		expect(about("setting:bunch/l")?.about).toMatch(/^Basics · [\d.]+ mm$/);
		expect(about("action:variation")?.keys).toBe("N");
		studio.setUi({ letters: false });
		expect(about("action:variation")?.keys).toBeUndefined();
		expect(about("action:undo")?.keys).toBe("Ctrl+Z");
		studio.setUi({ letters: true });
	});

	it("begins with the entries that were run last, and then suggests actions, each once", () => {
		const [recent, suggested] = entriesToStart(studio, entries(), ["plant:leaf/ivy", "action:saved", "action:gone"]);
		expect(recent.entries.map(({ key }) => key)).toEqual(["plant:leaf/ivy", "action:saved"]);
		expect(suggested.entries.map(({ key }) => key)).toContain("action:variation");
		expect(suggested.entries.map(({ key }) => key)).not.toContain("action:saved");
	});

	it("begins with the plants that were open lately, newest first, without the one in view", async () => {
		const { model, specimen } = studio.state;
		const plant = (id: string, link: string, at: number) => ({ id, link, title: `Plant ${id}`, at, editedAt: at });
		const now = Date.now();
		const stored = [
			plant("open", await encodeLink(model, specimen), now),
			plant("new", "?v=2&model=root&preset=carrot", now - 3_600_000),
			plant("old", "?v=2&model=leaf&preset=ivy&grow=6", now - 86_400_000),
		];
		const plants = await recentPlantEntries(studio, { all: async () => stored });
		const groups = entriesToStart(studio, entries(), ["plant:leaf/ivy", "action:saved"], plants);
		expect(groups.map(({ group }) => group)).toEqual(["recent_plants", "recent", "suggested"]);
		expect(groups[0].entries.map(({ title, about }) => [title, about])).toEqual([
			["Plant new", "edited 1 hour ago"],
			["Plant old", "edited yesterday"],
		]);
		expect(groups[1].entries.map(({ key }) => key)).toEqual(["action:saved"]);
		await groups[0].entries[0].run();
		expect(studio.state.specimen).toMatchObject({ model: "root", preset: "carrot" });
		studio.undo();
	});
});

describe("recent entries", () => {
	const storageOf = (stored: string | null) => {
		let value = stored;
		const setItem = (_: string, next: string) => {
			value = next;
		};
		return { getItem: () => value, setItem };
	};

	it("are stored newest first, each once, and only a few", () => {
		const storage = storageOf(null);
		for (const key of ["a", "b", "c", "d", "e", "f", "b"]) rememberKey(key, storage);
		expect(recentKeys(storage)).toEqual(["b", "f", "e", "d", "c"]);
		expect(recentKeys(storage)).toHaveLength(MAX_RECENT);
	});

	it("are none where storage has something else or refuses", () => {
		expect(recentKeys(storageOf("{"))).toEqual([]);
		expect(recentKeys(storageOf('{"a":1}'))).toEqual([]);
		expect(recentKeys(storageOf('[1,"a"]'))).toEqual(["a"]);
		const full = { getItem: () => null, setItem: () => expect.fail() };
		expect(() => rememberKey("a", full)).not.toThrow();
	});
});
