/** The hints that a visitor has seen to, in local storage. */
import { localStorageOr } from "../local_storage";

/** All hints, in the order in which they are shown. */
export const HINTS = ["point", "turn", "play"] as const;
export type HintKey = (typeof HINTS)[number];

type HintStorage = Pick<Storage, "getItem" | "setItem">;

export const STORAGE_KEY = "panicle.hints";

/** Returns the hints that are still to be shown; none where the page cannot remember that they were. */
export function hintsDue(storage: HintStorage = localStorageOr()): readonly HintKey[] {
	const done = doneIn(storage);
	const due = HINTS.filter((key) => !done.includes(key));
	return due.length > 0 && store(storage, done) ? due : [];
}

/** Stores that hints were followed or dismissed: they are never shown again. */
export function markDone(keys: readonly HintKey[], storage: HintStorage = localStorageOr()): void {
	store(storage, [...new Set([...doneIn(storage), ...keys])]);
}

/** Makes all hints due again. */
export function forgetDone(storage: HintStorage = localStorageOr()): void {
	store(storage, []);
}

/** Reads the hints that were followed or dismissed; none where the storage cannot be read. */
function doneIn(storage: HintStorage): readonly HintKey[] {
	try {
		const stored: unknown = JSON.parse(storage.getItem(STORAGE_KEY) ?? "[]");
		return Array.isArray(stored) ? HINTS.filter((key) => stored.includes(key)) : [];
	} catch {
		return [];
	}
}

/** Writes the hints that are done; returns whether the storage has them, false where it is full or forbidden. */
function store(storage: HintStorage, done: readonly HintKey[]): boolean {
	const written = JSON.stringify(done);
	try {
		storage.setItem(STORAGE_KEY, written);
		return storage.getItem(STORAGE_KEY) === written;
	} catch {
		return false;
	}
}
