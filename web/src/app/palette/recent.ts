/** The entries of the palette that were run last, in the browser's storage. */
import { localStorageOr } from "../local_storage";

const STORAGE_KEY = "panicle.palette";
export const MAX_RECENT = 5;

/** Returns the keys of the entries that were run last, newest first. */
export function recentKeys(storage: Pick<Storage, "getItem"> = localStorageOr()): readonly string[] {
	try {
		const stored: unknown = JSON.parse(storage.getItem(STORAGE_KEY) ?? "[]");
		return Array.isArray(stored) ? stored.filter((key) => typeof key === "string").slice(0, MAX_RECENT) : [];
	} catch {
		return [];
	}
}

/** Stores the key of an entry that is run. Does nothing where storage is full or forbidden. */
export function rememberKey(key: string, storage: Pick<Storage, "getItem" | "setItem"> = localStorageOr()): void {
	const keys = [key, ...recentKeys(storage).filter((each) => each !== key)].slice(0, MAX_RECENT);
	try {
		storage.setItem(STORAGE_KEY, JSON.stringify(keys));
	} catch {
		// Private windows may forbid storage: the palette works without.
	}
}
