/** The list of recent plants in this browser. Where its storage cannot be used, it is empty. */
import { localStorageOr } from "../local_storage";
import { IndexedRecent } from "./indexed_recent";
import { listed, MAX_RECENT, type RecentPlant, readRecent, recorded } from "./recent_plant";
import type { RecentContent, RecentStore } from "./recent_store";

/** A storage that writes at once, for plants of pages that are being left. */
export type DeferStorage = Pick<Storage, "getItem" | "setItem">;

/** The key of plants that are yet to be added to the list. */
const DEFERRED = "panicle.recent";

/** Plants that were removed from the list, with their contents. */
export type RemovedRecent = readonly { readonly plant: RecentPlant; readonly content: RecentContent }[];

export class Recents {
	readonly #store: RecentStore;
	readonly #storage: DeferStorage;

	constructor(store: RecentStore, storage: DeferStorage) {
		this.#store = store;
		this.#storage = storage;
	}

	/** Returns the list, newest first; only deferred plants where the storage cannot be read. */
	async all(): Promise<readonly RecentPlant[]> {
		try {
			await this.#addDeferred();
			return listed(await this.#store.all());
		} catch {
			return listed(this.#readDeferred());
		}
	}

	/** Returns the contents of a plant; empty where there are none. */
	async content(id: string): Promise<RecentContent> {
		return this.#store.content(id).catch(() => ({}));
	}

	/**
	 * Adds a plant, or replaces its entry. Where the storage is full, its picture and its extra fields are left out.
	 * @param from the link with which it was opened
	 * @returns the plant as listed; undefined if it is not listed
	 * @throws errors of the storage
	 */
	async record(plant: RecentPlant, content: RecentContent, from?: string): Promise<RecentPlant | undefined> {
		await this.#addDeferred();
		const isWhole = content.extra === undefined;
		try {
			return await this.#put(isWhole ? plant : { ...plant, extra: "stored" }, content, from);
		} catch {
			// Extra fields that are stored already may be those of an earlier state.
			return this.#put(isWhole ? plant : { ...plant, extra: "missing" }, {}, from);
		}
	}

	/**
	 * Writes a plant and its contents to the list; returns the plant as listed, or undefined if it is not listed.
	 * @param from the link with which it was opened
	 */
	async #put(plant: RecentPlant, content: RecentContent, from?: string): Promise<RecentPlant | undefined> {
		let after: readonly RecentPlant[] = [];
		await this.#store.change((stored) => {
			const { plants, replaced } = recorded(stored, plant, from);
			after = plants;
			return { plants, contents: new Map([[plant.id, content]]), replaced: new Map([[plant.id, replaced]]) };
		});
		return after.find(({ id }) => id === plant.id);
	}

	/** Stores a plant at once, for a page that is being left; the next call of `all` or `record` adds it to the list. */
	defer(plant: RecentPlant): void {
		try {
			const others = this.#readDeferred().filter(({ id }) => id !== plant.id);
			this.#storage.setItem(DEFERRED, JSON.stringify([plant, ...others].slice(0, MAX_RECENT)));
		} catch {
			// Storage is full or forbidden.
		}
	}

	/** Removes plants. @returns them for `restore`; none if the storage failed */
	async remove(ids: readonly string[]): Promise<RemovedRecent> {
		try {
			const plants = (await this.all()).filter(({ id }) => ids.includes(id));
			const removed = await Promise.all(
				plants.map(async (plant) => ({ plant, content: await this.content(plant.id) })),
			);
			await this.#store.change((stored) => ({ plants: stored.filter(({ id }) => !ids.includes(id)) }));
			return removed;
		} catch {
			return [];
		}
	}

	/** Adds plants again that were removed. */
	async restore(removed: RemovedRecent): Promise<void> {
		const contents = new Map(removed.map(({ plant, content }) => [plant.id, content]));
		const add = (stored: readonly RecentPlant[]) => {
			const others = stored.filter(({ id }) => !contents.has(id));
			return { plants: listed([...removed.map(({ plant }) => plant), ...others]), contents };
		};
		await this.#store.change(add).catch(() => {});
	}

	/**
	 * Moves the plants that `defer` has stored to the list, the oldest first; a plant that the list has in a newer state
	 * is left out.
	 */
	async #addDeferred(): Promise<void> {
		const deferred = this.#readDeferred();
		if (deferred.length === 0) return;
		for (const plant of deferred.toReversed()) {
			await this.#store.change((stored) => {
				// The page may have stored a newer state after all.
				const isOld = stored.some(({ id, at }) => id === plant.id && at >= plant.at);
				const { plants, replaced } = isOld ? { plants: stored, replaced: [] } : recorded(stored, plant);
				return { plants, replaced: new Map([[plant.id, replaced]]) };
			});
		}
		this.#storage.setItem(DEFERRED, "");
	}

	/** Reads the plants that `defer` has stored; none where the storage cannot be read. */
	#readDeferred(): readonly RecentPlant[] {
		try {
			const stored: unknown = JSON.parse(this.#storage.getItem(DEFERRED) || "[]");
			return Array.isArray(stored) ? stored.slice(0, MAX_RECENT).flatMap((each) => readRecent(each) ?? []) : [];
		} catch {
			return [];
		}
	}
}

let own: Recents | undefined;

/** Returns the list that all tabs of this browser share. */
export function ownRecents(): Recents {
	own ??= new Recents(new IndexedRecent(), localStorageOr());
	return own;
}
