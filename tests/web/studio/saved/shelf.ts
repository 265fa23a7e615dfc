import type { Saved } from "../../../../web/src/studio/saved/saved";
import { type Edit, edited, type Shelf, ShelfError } from "../../../../web/src/studio/saved/shelf";

/** A shelf that several libraries share, as tabs share a browser's. Steps take turns, and each takes a while. */
export class SharedShelf implements Shelf {
	kept: readonly Saved[] = [];
	/** Why nothing goes on it. */
	full: string | undefined;
	#last: Promise<unknown> = Promise.resolve();

	all(): Promise<readonly Saved[]> {
		return this.#inTurn(() => this.kept);
	}

	change(decide: (kept: readonly Saved[]) => Edit): Promise<readonly Saved[]> {
		return this.#inTurn(() => {
			const edit = decide(this.kept);
			if (this.full && edit.put?.length) throw new ShelfError(this.full);
			this.kept = edited(this.kept, edit);
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
