import { type Saved, sameness, uniqueName } from "./saved";
import { type Edit, edited, type Shelf } from "./shelf";

/** Tells the page's other tabs, and hears of them; a BroadcastChannel is one. */
export interface Tabs {
	postMessage(message: string): void;
	onmessage: ((event: MessageEvent) => void) | null;
}

/**
 * A person's own specimens. They are on the shelf; what that could not take stays here for as long as the page does, marked, so that it
 * can be exported or tried again: nothing is lost unsaid.
 */
export class Library {
	readonly #shelf: Shelf;
	readonly #tabs: Tabs | undefined;
	readonly #listeners = new Set<() => void>();
	#kept: readonly Saved[] = [];
	/** What the shelf did not take, by id; of those that are on it the newer state. */
	readonly #unkept = new Map<string, Saved>();
	#deleted: readonly Saved[] = [];
	#trouble: string | undefined;

	constructor(shelf: Shelf, tabs?: Tabs) {
		this.#shelf = shelf;
		this.#tabs = tabs;
		if (tabs) tabs.onmessage = () => void this.read();
	}

	/** All specimens, stored or not; stored ones are without pictures, which `withPictures` reads. */
	get all(): readonly Saved[] {
		return edited(this.#kept, { put: [...this.#unkept.values()] });
	}

	/** What goes with the page. */
	get unkept(): readonly Saved[] {
		return [...this.#unkept.values()];
	}

	isKept({ id }: Pick<Saved, "id">): boolean {
		return !this.#unkept.has(id);
	}

	/** What was deleted last, to be brought back. */
	get lastDeleted(): Saved | undefined {
		return this.#deleted.at(-1);
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
		const found = missing.length > 0 ? await this.#shelf.pictures(missing).catch(() => undefined) : undefined;
		return several.map((each) => {
			const picture = each.picture ?? found?.get(each.id);
			return picture ? { ...each, picture } : each;
		});
	}

	/** Looks what is on the shelf. */
	async read(): Promise<void> {
		await this.#try(() => this.#shelf.all());
	}

	/** Adds one, under a name of its own: "Merlot 2" where "Merlot" is taken. Returns it as it was added. */
	async add(saved: Saved): Promise<Saved> {
		const [added] = await this.#put((all) => {
			const names = all.map(({ name }) => name);
			return [{ ...saved, name: uniqueName(saved.name, names) }];
		});
		return added;
	}

	/** Adds those that are not there yet, by name and link; returns how many came. */
	async bring(several: readonly Saved[]): Promise<number> {
		const fresh = await this.#put((all) => {
			const known = new Set(all.map(sameness));
			return several.filter((each) => {
				const come = !known.has(sameness(each));
				known.add(sameness(each));
				return come;
			});
		});
		return fresh.length;
	}

	/** Another name for what may meanwhile be gone, in another tab: then it stays gone. */
	async rename(id: string, name: string): Promise<void> {
		await this.#put((all) => all.filter((each) => each.id === id).map((each) => ({ ...each, name })));
	}

	/** Takes one away; `undelete` brings it back. */
	async remove(id: string): Promise<void> {
		const unkept = this.#unkept.get(id);
		// One's picture never changes, so that it may be read before.
		const [before] = await this.withPictures(this.all.filter((each) => each.id === id));
		let gone = unkept;
		// What is here alone needs no shelf to go.
		const here = unkept && !this.#kept.some((each) => each.id === id);
		const done = await (here ||
			this.#change((kept) => {
				gone = unkept ?? kept.find((each) => each.id === id);
				return { remove: [id] };
			}));
		if (!done) return;
		this.#unkept.delete(id);
		if (gone) this.#deleted = [...this.#deleted, { ...before, ...gone }];
		this.#tell();
	}

	/** Brings back what was deleted last; returns it. */
	async undelete(): Promise<Saved | undefined> {
		const saved = this.lastDeleted;
		if (!saved) return undefined;
		this.#deleted = this.#deleted.slice(0, -1);
		await this.#put(() => [saved]);
		return saved;
	}

	/** Tries again to keep what could not be kept. */
	async keep(): Promise<void> {
		await this.#put(() => this.unkept);
	}

	/**
	 * Puts things on the shelf; where that does not take them, they stay here.
	 * @param make what, in sight of all there is, maybe more than once
	 * @returns what was made last
	 */
	async #put(make: (all: readonly Saved[]) => readonly Saved[]): Promise<readonly Saved[]> {
		let made: readonly Saved[] = [];
		const decide = (kept: readonly Saved[]) => {
			made = make(edited(kept, { put: this.unkept }));
			return { put: made };
		};
		const done = await this.#change(decide);
		if (!done) decide(this.#kept);
		for (const each of made) {
			if (done) this.#unkept.delete(each.id);
			else this.#unkept.set(each.id, each);
		}
		this.#tell();
		return made;
	}

	async #change(decide: (kept: readonly Saved[]) => Edit): Promise<boolean> {
		const done = await this.#try(() => this.#shelf.change(decide));
		if (done) this.#tabs?.postMessage("changed");
		return done;
	}

	/** Does something that gives what is on the shelf; tells whether it did. */
	async #try(step: () => Promise<readonly Saved[]>): Promise<boolean> {
		try {
			this.#kept = await step();
			this.#trouble = undefined;
			return true;
		} catch (error) {
			this.#trouble = error instanceof Error ? error.message : String(error);
			return false;
		} finally {
			this.#tell();
		}
	}

	#tell(): void {
		for (const listener of this.#listeners) listener();
	}
}
