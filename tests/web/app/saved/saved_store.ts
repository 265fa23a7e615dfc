import type { Saved } from "../../../../web/src/app/saved/saved";
import {
	type Edit,
	edited,
	type Pictures,
	type SavedStore,
	StoreError,
	withoutPicture,
} from "../../../../web/src/app/saved/saved_store";

/** A shelf that several libraries share, as tabs share a browser's. Steps take turns, and each takes a while. */
export class SharedStore implements SavedStore {
	kept: readonly Saved[] = [];
	readonly drawn = new Map<string, NonNullable<Saved["picture"]>>();
	/** Ids whose pictures were read. */
	readonly looked: string[] = [];
	/** Why nothing goes on it. */
	full: string | undefined;
	#last: Promise<unknown> = Promise.resolve();

	all(): Promise<readonly Saved[]> {
		return this.#inTurn(() => this.kept);
	}

	pictures(ids: readonly string[]): Promise<Pictures> {
		return this.#inTurn(() => {
			this.looked.push(...ids);
			return new Map([...this.drawn].filter(([id]) => ids.includes(id)));
		});
	}

	change(decide: (kept: readonly Saved[]) => Edit): Promise<readonly Saved[]> {
		return this.#inTurn(() => {
			const edit = decide(this.kept);
			if (this.full && edit.put?.length) throw new StoreError(this.full);
			for (const { id, picture } of edit.put ?? []) if (picture) this.drawn.set(id, picture);
			for (const id of edit.remove ?? []) this.drawn.delete(id);
			this.kept = edited(this.kept, { ...edit, put: edit.put?.map(withoutPicture) });
			return this.kept;
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
