import type { Message } from "../../locale/texts";
import { text } from "../messages.generated";
import { isSaved, type Saved } from "./saved";
import { type Edit, edited, type Pictures, type SavedStore, StoreError, withoutPicture } from "./saved_store";

const DATABASE = "panicle.saved";
/** Version of the database's layout. In version 1 the pictures were in the records of the specimens. */
const LAYOUT = 2;
/** Object stores: records without pictures by `id`, and pictures by the same ids. */
const [SPECIMENS, PICTURES] = ["specimens", "pictures"];

/**
 * Stores specimens in the browser's IndexedDB of this origin. Opens the database for each step and closes it
 * afterwards: a later version of the page in another tab never waits for this one, and a database that was deleted with
 * the browser's data is created anew.
 */
export class IndexedStore implements SavedStore {
	/** Reads all specimens, without pictures. */
	all(): Promise<readonly Saved[]> {
		return inOneStep((database) => applyEdit(database, "readonly", () => ({})));
	}

	/** Reads the pictures of specimens by their ids. */
	pictures(ids: readonly string[]): Promise<Pictures> {
		return inOneStep((database) => picturesOf(database, ids));
	}

	/** Changes the store in one transaction. */
	change(decide: (stored: readonly Saved[]) => Edit): Promise<readonly Saved[]> {
		return inOneStep((database) => applyEdit(database, "readwrite", decide));
	}
}

/** Opens the database for one step. Browsers serialise writing transactions, across tabs, too. */
async function inOneStep<T>(step: (database: IDBDatabase) => Promise<T>): Promise<T> {
	try {
		const database = await openStoreDatabase();
		try {
			return await step(database);
		} finally {
			database.close();
		}
	} catch (error) {
		throw new StoreError(messageFor(error));
	}
}

/** Opens the database, and converts that of version 1, whose records held their pictures. */
function openStoreDatabase(): Promise<IDBDatabase> {
	return new Promise((resolve, reject) => {
		const request = indexedDB.open(DATABASE, LAYOUT);
		request.onupgradeneeded = ({ oldVersion }) => {
			const { result: database, transaction } = request;
			if (oldVersion < 1) database.createObjectStore(SPECIMENS, { keyPath: "id" });
			const pictures = database.createObjectStore(PICTURES);
			if (oldVersion === 1 && transaction) takeOutPictures(transaction.objectStore(SPECIMENS), pictures);
		};
		request.onsuccess = () => resolve(request.result);
		request.onerror = () => reject(request.error);
	});
}

/** Migrates from the first layout to the second, record by record; other records are left unchanged. */
function takeOutPictures(specimens: IDBObjectStore, pictures: IDBObjectStore): void {
	const cursorRequest = specimens.openCursor();
	cursorRequest.onsuccess = () => {
		const cursor = cursorRequest.result;
		if (!cursor) return;
		if (isSaved(cursor.value) && cursor.value.picture) {
			pictures.put(cursor.value.picture, cursor.value.id);
			cursor.update(withoutPicture(cursor.value));
		}
		cursor.continue();
	};
}

/**
 * Applies an edit in one transaction: `decide` receives the stored records and returns the records to put and remove. If it
 * throws, or the disk is full, nothing is changed.
 * @returns the records after the edit, without pictures
 */
function applyEdit(
	database: IDBDatabase,
	mode: IDBTransactionMode,
	decide: (stored: readonly Saved[]) => Edit,
): Promise<readonly Saved[]> {
	return new Promise((resolve, reject) => {
		// Strict durability: completes once the data is on the disk, so that a full disk is reported.
		const transaction = database.transaction([SPECIMENS, PICTURES], mode, { durability: "strict" });
		const specimens = transaction.objectStore(SPECIMENS);
		const pictures = transaction.objectStore(PICTURES);
		const reading = specimens.getAll();
		let after: readonly Saved[] = [];
		let failed: unknown;
		reading.onsuccess = () => {
			try {
				const stored = reading.result.filter(isSaved);
				const { put = [], remove = [] } = decide(stored);
				for (const id of remove) {
					specimens.delete(id);
					pictures.delete(id);
				}
				const records = put.map(withoutPicture);
				for (const record of records) specimens.put(record);
				for (const { id, picture } of put) if (picture) pictures.put(picture, id);
				after = edited(stored, { put: records, remove });
			} catch (error) {
				failed = error;
				transaction.abort();
			}
		};
		transaction.oncomplete = () => resolve(after);
		transaction.onabort = () => reject(failed ?? transaction.error);
	});
}

/** Reads pictures by the ids of their records; those without a picture are missing from the result. */
function picturesOf(database: IDBDatabase, ids: readonly string[]): Promise<Pictures> {
	return new Promise((resolve, reject) => {
		const transaction = database.transaction(PICTURES, "readonly");
		const store = transaction.objectStore(PICTURES);
		const found = new Map<string, NonNullable<Saved["picture"]>>();
		for (const id of ids) {
			const reading = store.get(id);
			reading.onsuccess = () => {
				if (reading.result instanceof Uint8Array) found.set(id, reading.result as NonNullable<Saved["picture"]>);
			};
		}
		transaction.oncomplete = () => resolve(found);
		transaction.onabort = () => reject(transaction.error);
	});
}

/** Returns the message for an error of the database: full, newer, or forbidden. */
function messageFor(error: unknown): Message {
	const name = error instanceof Error ? error.name : String(error);
	if (name === "QuotaExceededError") return text.message("store_full");
	if (name === "VersionError") return text.message("store_newer");
	return text.message("store_forbidden", { error: name });
}
