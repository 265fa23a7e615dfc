import { type Saved, sameness, uniqueName } from "./saved";
import { type Edit, edited, type SavedStore } from "./saved_store";

/** Sends messages between the page's tabs; implemented by BroadcastChannel. */
export interface Tabs {
	postMessage(message: string): void;
	onmessage: ((event: MessageEvent) => void) | null;
}

/** A change of the library that `undo` reverts. */
export interface LibraryStep {
	readonly kind: "deletion" | "import";
	/** The specimens that were deleted or imported, as they were then; of an import only those still in the library. */
	readonly specimens: readonly Saved[];
}

/** A deleted specimen. Its picture is a Blob, which the browser may hold on the disk to save memory. */
interface Deleted {
	readonly saved: Saved;
	readonly picture: Blob | undefined;
}

type Step =
	| { readonly kind: "deletion"; readonly deleted: readonly Deleted[] }
	| { readonly kind: "import"; readonly ids: ReadonlySet<string> };

/** Number of pictures read at once. */
const MAX_PICTURES = 500;

/**
 * The user's saved specimens, in a store. Specimens that could not be stored stay in memory until the page is closed,
 * marked as such, so that they can be exported or stored again.
 */
export class Library {
	readonly #store: SavedStore;
	readonly #tabs: Tabs | undefined;
	readonly #listeners = new Set<() => void>();
	#stored: readonly Saved[] = [];
	/** Specimens that could not be stored, by id; newer than stored ones of the same id. */
	readonly #unstored = new Map<string, Saved>();
	/** Steps that can be undone, the last at the end. */
	#steps: readonly Step[] = [];
	#trouble: string | undefined;

	constructor(store: SavedStore, tabs?: Tabs) {
		this.#store = store;
		this.#tabs = tabs;
		if (tabs) tabs.onmessage = () => void this.read();
	}

	/** All specimens, stored or not; stored ones are without pictures, which `withPictures` reads. */
	get all(): readonly Saved[] {
		return edited(this.#stored, { put: [...this.#unstored.values()] });
	}

	/** Specimens that are not stored and are lost when the page is closed. */
	get unstored(): readonly Saved[] {
		return [...this.#unstored.values()];
	}

	/** Returns whether a specimen is stored. */
	isStored({ id }: Pick<Saved, "id">): boolean {
		return !this.#unstored.has(id);
	}

	/** The step that `undo` reverts; undefined if there is none. */
	get lastStep(): LibraryStep | undefined {
		const step = this.#steps.at(-1);
		if (step?.kind === "deletion") return { kind: step.kind, specimens: step.deleted.map(({ saved }) => saved) };
		return step && { kind: step.kind, specimens: this.all.filter(({ id }) => step.ids.has(id)) };
	}

	/** The error of the store's last step, a sentence; undefined after success. */
	get trouble(): string | undefined {
		return this.#trouble;
	}

	/** Calls back after every change, those of other tabs included; returns the function that ends it. */
	subscribe(listener: () => void): () => void {
		this.#listeners.add(listener);
		return () => this.#listeners.delete(listener);
	}

	/** Returns specimens with their pictures, if the store can be read. */
	async withPictures(several: readonly Saved[]): Promise<readonly Saved[]> {
		const missing = several.flatMap(({ id, picture }) => (picture ? [] : [id]));
		const found = missing.length > 0 ? await this.#store.pictures(missing).catch(() => undefined) : undefined;
		return several.map((each) => {
			const picture = each.picture ?? found?.get(each.id);
			return picture ? { ...each, picture } : each;
		});
	}

	/** Reads the store. */
	async read(): Promise<void> {
		await this.#try(() => this.#store.all());
	}

	/** Adds a specimen under a unique name: "Merlot 2" where "Merlot" is taken. @returns the specimen as added */
	async add(saved: Saved): Promise<Saved> {
		const [added] = await this.#put((all) => {
			const names = all.map(({ name }) => name);
			return [{ ...saved, name: uniqueName(saved.name, names) }];
		});
		return added;
	}

	/** Adds the specimens that are new by name and link, as one step of `undo`. @returns their number */
	async bring(several: readonly Saved[]): Promise<number> {
		const added = await this.#put((all) => {
			const existing = new Set(all.map(sameness));
			return several.filter((each) => {
				const isNew = !existing.has(sameness(each));
				existing.add(sameness(each));
				return isNew;
			});
		});
		if (added.length > 0) this.#addStep({ kind: "import", ids: new Set(added.map(({ id }) => id)) });
		return added.length;
	}

	/** Renames a specimen; does nothing if another tab has deleted it. */
	async rename(id: string, name: string): Promise<void> {
		await this.#put((all) => all.filter((each) => each.id === id).map((each) => ({ ...each, name })));
	}

	/** Deletes specimens as one step of `undo`. @returns the deleted ones */
	async remove(ids: readonly string[]): Promise<readonly Saved[]> {
		const idSet = new Set(ids);
		// A picture never changes, so it can be read before the step.
		const pictures = await this.#picturesOf(this.all.filter(({ id }) => idSet.has(id)));
		const removed = await this.#remove(idSet);
		const deleted = removed.map(({ picture, ...saved }) => ({
			saved,
			picture: picture ? new Blob([picture]) : pictures.get(saved.id),
		}));
		if (deleted.length > 0) this.#addStep({ kind: "deletion", deleted });
		return removed;
	}

	/** Reverts the last step: adds deleted specimens, deletes imported ones. @returns the step if it was reverted */
	async undo(): Promise<LibraryStep | undefined> {
		const [step, stepInList] = [this.#steps.at(-1), this.lastStep];
		if (!step) return undefined;
		this.#steps = this.#steps.slice(0, -1);
		if (step.kind === "deletion") {
			const specimens = await Promise.all(step.deleted.map(withItsPicture));
			await this.#put(() => specimens);
			return { kind: step.kind, specimens };
		}
		const removed = await this.#remove(step.ids);
		if (removed.length > 0 || stepInList?.specimens.length === 0) return { kind: step.kind, specimens: removed };
		// The store failed: the step can be reverted later.
		this.#addStep(step);
		return undefined;
	}

	/** Tries again to store the specimens that could not be stored. */
	async keep(): Promise<void> {
		await this.#put(() => this.unstored);
	}

	/** Deletes specimens. @returns the deleted ones; fewer if the store fails */
	async #remove(ids: ReadonlySet<string>): Promise<readonly Saved[]> {
		const stored = new Set(this.#stored.map(({ id }) => id));
		// Specimens that were never stored are deleted without the store.
		const unstored = this.unstored.filter(({ id }) => ids.has(id) && !stored.has(id));
		let removed: readonly Saved[] = unstored;
		if (unstored.length < ids.size) {
			const isStored = await this.#change((stored) => {
				removed = edited(stored, { put: this.unstored }).filter(({ id }) => ids.has(id));
				return { remove: removed.map(({ id }) => id) };
			});
			if (!isStored) removed = unstored;
		}
		for (const { id } of removed) this.#unstored.delete(id);
		this.#notifyListeners();
		return removed;
	}

	/** Reads the pictures of specimens, some at a time. */
	async #picturesOf(several: readonly Saved[]): Promise<ReadonlyMap<string, Blob>> {
		const pictures = new Map<string, Blob>();
		for (let from = 0; from < several.length; from += MAX_PICTURES) {
			for (const { id, picture } of await this.withPictures(several.slice(from, from + MAX_PICTURES))) {
				if (picture) pictures.set(id, new Blob([picture]));
			}
		}
		return pictures;
	}

	/** Adds a step that `undo` can revert. */
	#addStep(step: Step): void {
		this.#steps = [...this.#steps, step];
		this.#notifyListeners();
	}

	/**
	 * Stores specimens; on failure they stay in memory.
	 * @param make returns the specimens to store, given all there are; may be called twice
	 * @returns the specimens of the last call of `make`
	 */
	async #put(make: (all: readonly Saved[]) => readonly Saved[]): Promise<readonly Saved[]> {
		let specimens: readonly Saved[] = [];
		const decide = (stored: readonly Saved[]) => {
			specimens = make(edited(stored, { put: this.unstored }));
			return { put: specimens };
		};
		const isStored = await this.#change(decide);
		if (!isStored) decide(this.#stored);
		for (const each of specimens) {
			if (isStored) this.#unstored.delete(each.id);
			else this.#unstored.set(each.id, each);
		}
		this.#notifyListeners();
		return specimens;
	}

	/** Changes the store and notifies the other tabs; returns whether that succeeded. */
	async #change(decide: (stored: readonly Saved[]) => Edit): Promise<boolean> {
		const done = await this.#try(() => this.#store.change(decide));
		if (done) this.#tabs?.postMessage("changed");
		return done;
	}

	/** Runs a step that returns the stored specimens. @returns whether it succeeded */
	async #try(step: () => Promise<readonly Saved[]>): Promise<boolean> {
		try {
			this.#stored = await step();
			this.#trouble = undefined;
			return true;
		} catch (error) {
			this.#trouble = error instanceof Error ? error.message : String(error);
			return false;
		} finally {
			this.#notifyListeners();
		}
	}

	/** Calls all listeners of `subscribe`. */
	#notifyListeners(): void {
		for (const listener of this.#listeners) listener();
	}
}

/** Returns a deleted specimen with its picture. */
async function withItsPicture({ saved, picture }: Deleted): Promise<Saved> {
	return picture ? { ...saved, picture: new Uint8Array(await picture.arrayBuffer()) } : saved;
}
