/** Where specimens are kept. The browser's own is indexed_shelf.ts. */
import type { Saved } from "./saved";

/** What is to be done on the shelf. */
export interface Edit {
	/** Stored in place of those with the same ids; one without a picture keeps the stored picture. */
	readonly put?: readonly Saved[];
	/** Ids of specimens to delete, with their pictures. */
	readonly remove?: readonly string[];
}

/** A small JPEG for each id that has one. */
export type Pictures = ReadonlyMap<string, NonNullable<Saved["picture"]>>;

/** Stores specimens, and their pictures apart from them: pictures are most of the bytes, and few steps need them. */
export interface SavedStore {
	/** Everything that is kept, in no order, without pictures. @throws StoreError */
	all(): Promise<readonly Saved[]>;
	/** The pictures of these alone. @throws StoreError */
	pictures(ids: readonly string[]): Promise<Pictures>;
	/**
	 * One step during which no other tab writes: all of it is done, or nothing.
	 * @param decide what to do, in sight of all that is kept now, without pictures
	 * @returns all that is kept afterwards, without pictures
	 * @throws StoreError where nothing was done
	 */
	change(decide: (stored: readonly Saved[]) => Edit): Promise<readonly Saved[]>;
}

/** The shelf keeps nothing now; the message is a sentence that says why. */
export class StoreError extends Error {
	override name = "StoreError";
}

/** What is there once an edit is done. */
export function edited(stored: readonly Saved[], { put = [], remove = [] }: Edit): readonly Saved[] {
	const gone = new Set([...remove, ...put.map(({ id }) => id)]);
	return [...stored.filter(({ id }) => !gone.has(id)), ...put];
}

/** A specimen as the shelf lists it. */
export function withoutPicture({ picture: _, ...saved }: Saved): Saved {
	return saved;
}
