import { type Saved, sameness, uniqueName } from "./saved";
import { type Edit, edited, type SavedStore } from "./saved_store";

/** Tells the page's other tabs, and hears of them; a BroadcastChannel is one. */
export interface Tabs {
	postMessage(message: string): void;
	onmessage: ((event: MessageEvent) => void) | null;
}

/** A change of the library that `undo` takes back. */
export interface LibraryStep {
	readonly kind: "deletion" | "import";
	/** The specimens that it deleted or imported, as they were then; of an import those that are in the library still. */
	readonly specimens: readonly Saved[];
}

/** A deleted specimen. Its picture is a Blob, which the browser may keep on the disk: the pictures of a whole library need much memory. */
interface Deleted {
	readonly saved: Saved;
	readonly picture: Blob | undefined;
}

type Step =
	| { readonly kind: "deletion"; readonly deleted: readonly Deleted[] }
	| { readonly kind: "import"; readonly ids: ReadonlySet<string> };

/** Pictures read at once. */
const MOST_PICTURES = 500;

/**
 * A person's own specimens. They are on the shelf; what that could not take stays here for as long as the page does, marked, so that it
 * can be exported or tried again: nothing is lost unsaid.
 */
export class Library {
	readonly #store: SavedStore;
	readonly #tabs: Tabs | undefined;
	readonly #listeners = new Set<() => void>();
	#stored: readonly Saved[] = [];
	/** What the shelf did not take, by id; of those that are on it the newer state. */
	readonly #unstored = new Map<string, Saved>();
	/** What can be undone, the last step last. */
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

	/** What goes with the page. */
	get unstored(): readonly Saved[] {
		return [...this.#unstored.values()];
	}

	isStored({ id }: Pick<Saved, "id">): boolean {
		return !this.#unstored.has(id);
	}

	/** The step that `undo` takes back; undefined where there is none. */
	get lastStep(): LibraryStep | undefined {
		const step = this.#steps.at(-1);
		if (step?.kind === "deletion") return { kind: step.kind, specimens: step.deleted.map(({ saved }) => saved) };
		return step && { kind: step.kind, specimens: this.all.filter(({ id }) => step.ids.has(id)) };
	}

	/** Why the shelf did not do what it was last asked for; a sentence. */
	get trouble(): string | undefined {
		return this.#trouble;
	}

	/** Calls back after every change, those of other tabs included; returns the function that ends it. */
	subscribe(listener: () => void): () => void {
		this.#listeners.add(listener);
		return () => this.#listeners.delete(listener);
	}

	/** The given specimens with their pictures, if the shelf can be read. */
	async withPictures(several: readonly Saved[]): Promise<readonly Saved[]> {
		const missing = several.flatMap(({ id, picture }) => (picture ? [] : [id]));
		const found = missing.length > 0 ? await this.#store.pictures(missing).catch(() => undefined) : undefined;
		return several.map((each) => {
			const picture = each.picture ?? found?.get(each.id);
			return picture ? { ...each, picture } : each;
		});
	}

	/** Looks what is on the shelf. */
	async read(): Promise<void> {
		await this.#try(() => this.#store.all());
	}

	/** Adds one, under a name of its own: "Merlot 2" where "Merlot" is taken. Returns it as it was added. */
	async add(saved: Saved): Promise<Saved> {
		const [added] = await this.#put((all) => {
			const names = all.map(({ name }) => name);
			return [{ ...saved, name: uniqueName(saved.name, names) }];
		});
		return added;
	}

	/** Adds those that are not there yet, by name and link, as one step of `undo`; returns how many came. */
	async bring(several: readonly Saved[]): Promise<number> {
		const fresh = await this.#put((all) => {
			const known = new Set(all.map(sameness));
			return several.filter((each) => {
				const come = !known.has(sameness(each));
				known.add(sameness(each));
				return come;
			});
		});
		if (fresh.length > 0) this.#done({ kind: "import", ids: new Set(fresh.map(({ id }) => id)) });
		return fresh.length;
	}

	/** Another name for what may meanwhile be gone, in another tab: then it stays gone. */
	async rename(id: string, name: string): Promise<void> {
		await this.#put((all) => all.filter((each) => each.id === id).map((each) => ({ ...each, name })));
	}

	/** Deletes specimens as one step of `undo`; returns those that were deleted. */
	async remove(ids: readonly string[]): Promise<readonly Saved[]> {
		const wanted = new Set(ids);
		// A picture never changes, so that it may be read before.
		const pictures = await this.#picturesOf(this.all.filter(({ id }) => wanted.has(id)));
		const gone = await this.#remove(wanted);
		const deleted = gone.map(({ picture, ...saved }) => ({
			saved,
			picture: picture ? new Blob([picture]) : pictures.get(saved.id),
		}));
		if (deleted.length > 0) this.#done({ kind: "deletion", deleted });
		return gone;
	}

	/** Takes the last step back: deleted specimens are added, imported ones deleted. Returns the step if it was undone. */
	async undo(): Promise<LibraryStep | undefined> {
		const [step, described] = [this.#steps.at(-1), this.lastStep];
		if (!step) return undefined;
		this.#steps = this.#steps.slice(0, -1);
		if (step.kind === "deletion") {
			const specimens = await Promise.all(step.deleted.map(withItsPicture));
			await this.#put(() => specimens);
			return { kind: step.kind, specimens };
		}
		const gone = await this.#remove(step.ids);
		if (gone.length > 0 || described?.specimens.length === 0) return { kind: step.kind, specimens: gone };
		// The shelf did not do it: it can be tried again.
		this.#done(step);
		return undefined;
	}

	/** Tries again to keep what could not be kept. */
	async keep(): Promise<void> {
		await this.#put(() => this.unstored);
	}

	/** Deletes specimens; returns those that were deleted, which is fewer where the shelf does not do it. */
	async #remove(ids: ReadonlySet<string>): Promise<readonly Saved[]> {
		const stored = new Set(this.#stored.map(({ id }) => id));
		// What was never stored needs no shelf to go.
		const here = this.unstored.filter(({ id }) => ids.has(id) && !stored.has(id));
		let gone: readonly Saved[] = here;
		if (here.length < ids.size) {
			const done = await this.#change((stored) => {
				gone = edited(stored, { put: this.unstored }).filter(({ id }) => ids.has(id));
				return { remove: gone.map(({ id }) => id) };
			});
			if (!done) gone = here;
		}
		for (const { id } of gone) this.#unstored.delete(id);
		this.#notifyListeners();
		return gone;
	}

	async #picturesOf(several: readonly Saved[]): Promise<ReadonlyMap<string, Blob>> {
		const found = new Map<string, Blob>();
		for (let from = 0; from < several.length; from += MOST_PICTURES) {
			for (const { id, picture } of await this.withPictures(several.slice(from, from + MOST_PICTURES))) {
				if (picture) found.set(id, new Blob([picture]));
			}
		}
		return found;
	}

	#done(step: Step): void {
		this.#steps = [...this.#steps, step];
		this.#notifyListeners();
	}

	/**
	 * Puts things on the shelf; where that does not take them, they stay here.
	 * @param make what, in sight of all there is, maybe more than once
	 * @returns what was made last
	 */
	async #put(make: (all: readonly Saved[]) => readonly Saved[]): Promise<readonly Saved[]> {
		let made: readonly Saved[] = [];
		const decide = (stored: readonly Saved[]) => {
			made = make(edited(stored, { put: this.unstored }));
			return { put: made };
		};
		const done = await this.#change(decide);
		if (!done) decide(this.#stored);
		for (const each of made) {
			if (done) this.#unstored.delete(each.id);
			else this.#unstored.set(each.id, each);
		}
		this.#notifyListeners();
		return made;
	}

	async #change(decide: (stored: readonly Saved[]) => Edit): Promise<boolean> {
		const done = await this.#try(() => this.#store.change(decide));
		if (done) this.#tabs?.postMessage("changed");
		return done;
	}

	/** Does something that gives what is on the shelf; tells whether it did. */
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

	#notifyListeners(): void {
		for (const listener of this.#listeners) listener();
	}
}

async function withItsPicture({ saved, picture }: Deleted): Promise<Saved> {
	return picture ? { ...saved, picture: new Uint8Array(await picture.arrayBuffer()) } : saved;
}
