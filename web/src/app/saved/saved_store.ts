/** The interface of a store of specimens; indexed_store.ts implements it in the browser. */
import { MessageError } from "../../locale/message_error";
import type { Saved } from "./saved";

/** An edit of the store. */
export interface Edit {
	/** Specimens to add or replace by id; one without a picture retains the stored picture. */
	readonly put?: readonly Saved[];
	/** Ids of specimens to delete, with their pictures. */
	readonly remove?: readonly string[];
}

/** A small JPEG for each id that has one. */
export type Pictures = ReadonlyMap<string, NonNullable<Saved["picture"]>>;

/** Stores specimens, and their pictures apart from them: pictures are most of the bytes, and few steps need them. */
export interface SavedStore {
	/** All stored specimens, in no order, without pictures. @throws StoreError */
	all(): Promise<readonly Saved[]>;
	/** The pictures of some specimens. @throws StoreError */
	pictures(ids: readonly string[]): Promise<Pictures>;
	/**
	 * One atomic edit, during which no other tab writes.
	 * @param decide returns the edit, given all stored specimens without pictures
	 * @returns all specimens stored afterwards, without pictures
	 * @throws StoreError if nothing was changed
	 */
	change(decide: (stored: readonly Saved[]) => Edit): Promise<readonly Saved[]>;
}

/** The store cannot be used; the message has the reason. */
export class StoreError extends MessageError {
	override name = "StoreError";
}

/** Returns the stored specimens after an edit. */
export function edited(stored: readonly Saved[], { put = [], remove = [] }: Edit): readonly Saved[] {
	const gone = new Set([...remove, ...put.map(({ id }) => id)]);
	return [...stored.filter(({ id }) => !gone.has(id)), ...put];
}

/** Returns a specimen without its picture. */
export function withoutPicture({ picture: _, ...saved }: Saved): Saved {
	return saved;
}
