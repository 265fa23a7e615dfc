import { expect, it } from "vitest";
import { forgetDone, HINTS, hintsDue, markDone, STORAGE_KEY } from "../../../../web/src/app/hints/hint_store";

function storageOf(stored: string | null = null) {
	let value = stored;
	const setItem = (_: string, next: string) => {
		value = next;
	};
	return { getItem: () => value, setItem, written: () => value };
}

it("shows a new visitor all hints, and each only until it is done", () => {
	const storage = storageOf();
	expect(hintsDue(storage)).toEqual(HINTS);
	markDone(["turn"], storage);
	markDone(["turn", "point"], storage);
	expect(hintsDue(storage)).toEqual(["play"]);
	markDone(HINTS, storage);
	expect(hintsDue(storage)).toEqual([]);
	forgetDone(storage);
	expect(hintsDue(storage)).toEqual(HINTS);
});

it("writes the key that tests of the page set", async () => {
	const { withoutHints } = await import("../../../e2e/without_hints.mjs");
	const storage = storageOf();
	markDone(HINTS, storage);
	expect(withoutHints.toString()).toContain(`"${STORAGE_KEY}", '${storage.written()}'`);
});

it("survives any stored data", () => {
	for (const stored of ["{", '{"a":1}', '["point",4,null,"other"]'])
		expect(hintsDue(storageOf(stored)).length).toBeGreaterThanOrEqual(2);
	expect(hintsDue(storageOf('["point",4,null,"other"]'))).toEqual(["turn", "play"]);
});

it("shows no hints where the page cannot remember that they were shown", () => {
	expect(hintsDue({ getItem: () => null, setItem: () => {} })).toEqual([]);
	const full = () => {
		throw new DOMException("full", "QuotaExceededError");
	};
	expect(hintsDue({ getItem: () => null, setItem: full })).toEqual([]);
	expect(() => markDone(["turn"], { getItem: () => null, setItem: full })).not.toThrow();
});
