import { LARGEST_PICTURE } from "../saved/jpeg_size";
import { type RecentPlant, readRecent } from "./recent_plant";
import type { RecentChange, RecentContent, RecentStore } from "./recent_store";

const DATABASE = "panicle.recent";
const LAYOUT = 1;
/** Object stores: plants by `id`, and pictures and extra fields by the same ids. */
const [PLANTS, PICTURES, EXTRAS] = ["plants", "pictures", "extras"];
/** The most records that are read: more than the page ever writes. */
const MOST_RECORDS = 64;
/** The most characters of extra fields; meshes have a limit far below. */
const LONGEST_EXTRA = 8_000_000;

/**
 * Stores recent plants in the browser's IndexedDB of this origin. Opens the database for each step, as
 * saved/indexed_store.ts does: a later version of the page in another tab never waits for this one.
 */
export class IndexedRecent implements RecentStore {
	/** Reads the valid plants of the store. */
	all(): Promise<readonly RecentPlant[]> {
		return inOneStep("readonly", ([plants]) => readValid(plants));
	}

	/** Reads picture and extra fields of a plant. */
	content(id: string): Promise<RecentContent> {
		return inOneStep("readonly", async ([, pictures, extras]) => {
			const [picture, extra] = await Promise.all([resultOf(pictures.get(id)), resultOf(extras.get(id))]);
			return { picture: validPicture(picture), extra: validExtra(extra) };
		});
	}

	/** Changes the list in one transaction. */
	change(decide: (stored: readonly RecentPlant[]) => RecentChange): Promise<void> {
		return inOneStep("readwrite", async ([plants, pictures, extras]) => {
			const { plants: next, contents, replaced } = decide(await readValid(plants));
			plants.clear();
			for (const plant of next) plants.put(plant);
			await replaceIn(pictures, next, replaced, (id) => contents?.get(id)?.picture, validPicture);
			await replaceIn(extras, next, replaced, (id) => contents?.get(id)?.extra, validExtra);
		});
	}
}

/** Runs a step in one transaction, and resolves when it is completed; an error reverts it. */
async function inOneStep<T>(mode: IDBTransactionMode, step: (stores: IDBObjectStore[]) => Promise<T>): Promise<T> {
	const database = await openDatabase();
	try {
		const names = [PLANTS, PICTURES, EXTRAS];
		const transaction = database.transaction(names, mode);
		const completed = new Promise<void>((resolve, reject) => {
			transaction.oncomplete = () => resolve();
			transaction.onabort = () => reject(transaction.error ?? new Error("The step was aborted."));
		});
		// The step's own error is the one to report.
		completed.catch(() => {});
		try {
			const result = await step(names.map((name) => transaction.objectStore(name)));
			await completed;
			return result;
		} catch (error) {
			if (transaction.error === null) abort(transaction);
			throw error;
		}
	} finally {
		database.close();
	}
}

/** Ends a transaction without its changes; does nothing where it has ended already. */
function abort(transaction: IDBTransaction): void {
	try {
		transaction.abort();
	} catch {
		// It has ended already.
	}
}

/** Opens the database, and creates it at the first use. */
function openDatabase(): Promise<IDBDatabase> {
	return new Promise((resolve, reject) => {
		const request = indexedDB.open(DATABASE, LAYOUT);
		request.onupgradeneeded = () => {
			request.result.createObjectStore(PLANTS, { keyPath: "id" });
			for (const name of [PICTURES, EXTRAS]) request.result.createObjectStore(name);
		};
		request.onsuccess = () => resolve(request.result);
		request.onerror = () => reject(request.error);
	});
}

/** Converts a request of the database to a promise of its result. */
function resultOf<T>(request: IDBRequest<T>): Promise<T> {
	return new Promise((resolve, reject) => {
		request.onsuccess = () => resolve(request.result);
		request.onerror = () => reject(request.error);
	});
}

/** Reads the valid plants of an object store; skips other records. */
async function readValid(plants: IDBObjectStore): Promise<readonly RecentPlant[]> {
	const records: unknown[] = await resultOf(plants.getAll(undefined, MOST_RECORDS));
	return records.flatMap((record) => readRecent(record) ?? []);
}

/**
 * Writes the contents of one kind: those that are new; where a plant has none, those of plants that it replaces. Deletes
 * the contents of plants that are not listed.
 */
async function replaceIn<T>(
	store: IDBObjectStore,
	plants: readonly RecentPlant[],
	replaced: RecentChange["replaced"],
	fresh: (id: string) => T | undefined,
	valid: (value: unknown) => T | undefined,
): Promise<void> {
	for (const { id } of plants) {
		const sources = fresh(id) === undefined ? [id, ...(replaced?.get(id) ?? [])] : [];
		const old = await Promise.all(sources.map((source) => resultOf(store.get(source))));
		const value = fresh(id) ?? old.map(valid).find((each) => each !== undefined);
		if (value === undefined) store.delete(id);
		else if (sources.length !== 1) store.put(value, id);
	}
	const ids = new Set<IDBValidKey>(plants.map(({ id }) => id));
	for (const key of await resultOf(store.getAllKeys())) if (!ids.has(key)) store.delete(key);
}

/** Returns a stored picture; undefined where it is none or too large. */
function validPicture(value: unknown): RecentContent["picture"] {
	const isPicture = value instanceof Uint8Array && value.length <= LARGEST_PICTURE;
	return isPicture ? (value as Uint8Array<ArrayBuffer>) : undefined;
}

/** Returns stored extra fields; undefined where they are none or too long. */
function validExtra(value: unknown): string | undefined {
	return typeof value === "string" && value.length <= LONGEST_EXTRA ? value : undefined;
}
