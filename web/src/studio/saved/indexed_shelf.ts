import { isSaved, type Saved } from "./saved";
import { type Edit, edited, type Shelf, ShelfError } from "./shelf";

const DATABASE = "panicle.saved";
/** Of the stores below. */
const LAYOUT = 1;
const STORE = "specimens";

/**
 * The browser's IndexedDB, of this origin. The database is opened for each step and closed after it: a later version of the page in
 * another tab never waits for this one to let go, and what is deleted with the browser's data is found gone, not broken.
 */
export class IndexedShelf implements Shelf {
	all(): Promise<readonly Saved[]> {
		return inOneStep("readonly", () => ({}));
	}

	change(decide: (kept: readonly Saved[]) => Edit): Promise<readonly Saved[]> {
		return inOneStep("readwrite", decide);
	}
}

/** Browsers let transactions that write wait for each other, be they of other tabs. */
async function inOneStep(
	mode: IDBTransactionMode,
	decide: (kept: readonly Saved[]) => Edit,
): Promise<readonly Saved[]> {
	try {
		const database = await opened();
		try {
			return await done(database, mode, decide);
		} finally {
			database.close();
		}
	} catch (error) {
		throw new ShelfError(sentenceFor(error));
	}
}

function opened(): Promise<IDBDatabase> {
	return new Promise((resolve, reject) => {
		const request = indexedDB.open(DATABASE, LAYOUT);
		request.onupgradeneeded = () => request.result.createObjectStore(STORE, { keyPath: "id" });
		request.onsuccess = () => resolve(request.result);
		request.onerror = () => reject(request.error);
	});
}

function done(
	database: IDBDatabase,
	mode: IDBTransactionMode,
	decide: (kept: readonly Saved[]) => Edit,
): Promise<readonly Saved[]> {
	return new Promise((resolve, reject) => {
		// Strict: it is kept once it is on the disk, so that a full one is heard of.
		const transaction = database.transaction(STORE, mode, { durability: "strict" });
		const store = transaction.objectStore(STORE);
		const reading = store.getAll();
		let after: readonly Saved[] = [];
		let failed: unknown;
		reading.onsuccess = () => {
			try {
				const kept = reading.result.filter(isSaved);
				const edit = decide(kept);
				for (const id of edit.remove ?? []) store.delete(id);
				for (const saved of edit.put ?? []) store.put(saved);
				after = edited(kept, edit);
			} catch (error) {
				failed = error;
				transaction.abort();
			}
		};
		transaction.oncomplete = () => resolve(after);
		transaction.onabort = () => reject(failed ?? transaction.error);
	});
}

function sentenceFor(error: unknown): string {
	const name = error instanceof Error ? error.name : String(error);
	if (name === "QuotaExceededError") return "The disk, or the part of it that the browser grants this page, is full.";
	if (name === "VersionError")
		return "A newer version of this page, in another tab, has taken over what is saved: load this page again.";
	return `The browser does not let this page keep anything, as in some private windows (${name}).`;
}
