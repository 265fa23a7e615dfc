import { describe, expect, it } from "vitest";
import { ago } from "../../../../web/src/app/recent/ago";
import { listed, MAX_RECENT, readRecent, recorded } from "../../../../web/src/app/recent/recent_plant";
import { languageOf, useLanguage } from "../../../../web/src/locale/locale";
import { plantAs } from "./recent_store";

const ids = (plants: readonly { id: string }[]) => plants.map(({ id }) => id);
const edited = (id: string, at: number) => plantAs(id, { at, editedAt: at });

describe("the list of recent plants", () => {
	it("has at most six, newest first", () => {
		const plants = Array.from({ length: 9 }, (_, i) => edited(`p${i}`, i + 1));
		expect(ids(listed(plants))).toEqual(["p8", "p7", "p6", "p5", "p4", "p3"]);
		expect(MAX_RECENT).toBe(6);
	});

	it("keeps edited plants before newer ones that were only looked at", () => {
		const seen = Array.from({ length: 6 }, (_, i) => plantAs(`seen${i}`, { at: 100 + i }));
		const plants = [...seen, edited("one", 1), edited("two", 2)];
		expect(ids(listed(plants))).toEqual(["seen5", "seen4", "seen3", "seen2", "two", "one"]);
		const six = Array.from({ length: 6 }, (_, i) => edited(`e${i}`, i + 1));
		expect(ids(recorded(six, plantAs("seen", { at: 100 })).plants)).toEqual(ids(listed(six)));
	});

	it("has one entry for a plant that is opened, edited, and opened again elsewhere", () => {
		const first = recorded([], edited("tab1", 10)).plants;
		const again = recorded(first, plantAs("tab2", { link: first[0].link, at: 20 }));
		expect(again.plants).toEqual([{ ...first[0], id: "tab2", title: "tab2", at: 20 }]);
		expect(again.replaced).toEqual(["tab1"]);
		// The first record after an edit names the link with which the plant was opened.
		const changed = recorded(first, plantAs("tab2", { link: "?v=2&l=1", at: 20, editedAt: 20 }), first[0].link);
		expect(ids(changed.plants)).toEqual(["tab2"]);
	});

	it("has two entries for a plant that two tabs edit", () => {
		const opened = recorded([edited("tab1", 10)], plantAs("tab2", { link: plantAs("tab1").link, at: 20 })).plants;
		const second = recorded(opened, plantAs("tab2", { link: "?v=2&l=2", at: 30, editedAt: 30 })).plants;
		const both = recorded(second, plantAs("tab1", { link: "?v=2&l=3", at: 40, editedAt: 40 })).plants;
		expect(both.map(({ link }) => link)).toEqual(["?v=2&l=3", "?v=2&l=2"]);
	});
});

describe("a stored record", () => {
	it("is read if it is a recent plant; unknown fields are dropped", () => {
		const whole = plantAs("a", { editedAt: 5, extra: "stored" });
		expect(readRecent({ ...whole, more: "x" })).toEqual(whole);
		expect(readRecent({ ...whole, editedAt: "soon", extra: 7 })).toEqual(plantAs("a"));
	});

	it.each<[string, unknown]>([
		["nothing", undefined],
		["null", null],
		["a text", "text"],
		["a list", []],
		["no id", {}],
		["an empty id", plantAs("")],
		["an id with a space", plantAs("a b")],
		["a script as link", plantAs("a", { link: "javascript:alert(1)" })],
		["a link to another site", plantAs("a", { link: "https://example.org/?v=2" })],
		["a long link", plantAs("a", { link: `?${"x".repeat(700_000)}` })],
		["an empty title", plantAs("a", { title: "" })],
		["a long title", plantAs("a", { title: "x".repeat(201) })],
		["no time", plantAs("a", { at: Number.NaN })],
		["a time beyond the calendar", plantAs("a", { at: 1e300 })],
		["a time before the browser", plantAs("a", { at: -1 })],
	])("is ignored if it is none: %s", (_, value) => {
		expect(readRecent(value)).toBeUndefined();
	});
});

describe("the time since an edit", () => {
	const now = Date.UTC(2026, 10, 27, 12);
	const since = (seconds: number) => ago(now - seconds * 1000, now);

	it("is in whole units, rounded down", async () => {
		expect([59, 60, 3599, 7200, 86_400, 20 * 86_400, 400 * 86_400].map(since)).toEqual([
			undefined,
			"1 minute ago",
			"59 minutes ago",
			"2 hours ago",
			"yesterday",
			"2 weeks ago",
			"last year",
		]);
		expect(since(-500)).toBeUndefined();
	});

	it("is in the language of the page", async () => {
		await useLanguage(languageOf("fr") as NonNullable<ReturnType<typeof languageOf>>);
		expect([since(7200), since(86_400)]).toEqual(["il y a 2 heures", "hier"]);
		await useLanguage(languageOf("en") as NonNullable<ReturnType<typeof languageOf>>);
	});
});
