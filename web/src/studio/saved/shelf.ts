/** Where specimens are kept. The browser's own is indexed_shelf.ts. */
import type { Saved } from "./saved";

/** What is to be done on the shelf. */
export interface Edit {
	/** Put there, in place of what has the same id. */
	readonly put?: readonly Saved[];
	/** Ids of what goes. */
	readonly remove?: readonly string[];
}

export interface Shelf {
	/** Everything that is kept, in no order. @throws ShelfError */
	all(): Promise<readonly Saved[]>;
	/**
	 * One step during which no other tab writes: all of it is done, or nothing.
	 * @param decide what to do, in sight of all that is kept now
	 * @returns all that is kept afterwards
	 * @throws ShelfError where nothing was done
	 */
	change(decide: (kept: readonly Saved[]) => Edit): Promise<readonly Saved[]>;
}

/** The shelf keeps nothing now; the message is a sentence that says why. */
export class ShelfError extends Error {
	override name = "ShelfError";
}

/** What is there once an edit is done. */
export function edited(kept: readonly Saved[], { put = [], remove = [] }: Edit): readonly Saved[] {
	const gone = new Set([...remove, ...put.map(({ id }) => id)]);
	return [...kept.filter(({ id }) => !gone.has(id)), ...put];
}
