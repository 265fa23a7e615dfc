import type { Saved } from "../../../../web/src/app/saved/saved";
import {
	type Edit,
	edited,
	type Pictures,
	type SavedStore,
	StoreError,
	withoutPicture,
} from "../../../../web/src/app/saved/saved_store";

/** A store shared by several libraries, as tabs share a browser's. Steps run one after the other, asynchronously. */
export class SharedStore implements SavedStore {
	stored: readonly Saved[] = [];
	readonly pictureOf = new Map<string, NonNullable<Saved["picture"]>>();
	/** Ids whose pictures were read. */
	readonly readPictures: string[] = [];
	/** Error of the store while it is full. */
	full: string | undefined;
	#last: Promise<unknown> = Promise.resolve();

	all(): Promise<readonly Saved[]> {
		return this.#inTurn(() => this.stored);
	}

	pictures(ids: readonly string[]): Promise<Pictures> {
		return this.#inTurn(() => {
			this.readPictures.push(...ids);
			return new Map([...this.pictureOf].filter(([id]) => ids.includes(id)));
		});
	}

	change(decide: (stored: readonly Saved[]) => Edit): Promise<readonly Saved[]> {
		return this.#inTurn(() => {
			const edit = decide(this.stored);
			if (this.full && edit.put?.length) throw new StoreError({ code: "app.store_full", args: {}, text: this.full });
			for (const { id, picture } of edit.put ?? []) if (picture) this.pictureOf.set(id, picture);
			for (const id of edit.remove ?? []) this.pictureOf.delete(id);
			this.stored = edited(this.stored, { ...edit, put: edit.put?.map(withoutPicture) });
			return this.stored;
		});
	}

	#inTurn<T>(step: () => T): Promise<T> {
		const turn = this.#last.then(() => new Promise((resolve) => setTimeout(resolve))).then(step);
		this.#last = turn.catch(() => {});
		return turn;
	}
}

let made = 0;

export const savedAs = (name: string, more: Partial<Saved> = {}): Saved => ({
	id: `id-${++made}`,
	name,
	link: "?v=2",
	at: 1_000 * made,
	app: "1.0.0",
	...more,
});
