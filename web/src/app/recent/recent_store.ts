/** The interface of a store of recent plants; indexed_recent.ts implements it in the browser. */
import type { RecentPlant } from "./recent_plant";

/** A small JPEG. */
export type RecentPicture = Uint8Array<ArrayBuffer>;

/** The parts of a plant that are read only when they are needed. */
export interface RecentContent {
	readonly picture?: RecentPicture | undefined;
	/** The fields that its link cannot hold (session/stored_specimen.ts). */
	readonly extra?: string | undefined;
}

/** The result of a change of the list. */
export interface RecentChange {
	/** The whole list; the contents of other plants are deleted. */
	readonly plants: readonly RecentPlant[];
	/** New contents by id; a part that is absent stays as it is. */
	readonly contents?: ReadonlyMap<string, RecentContent>;
	/** Ids of plants whose contents a plant takes over, by its id, where it has none. */
	readonly replaced?: ReadonlyMap<string, readonly string[]>;
}

export interface RecentStore {
	/** The valid plants of the store, in no order. */
	all(): Promise<readonly RecentPlant[]>;
	/** The contents of a plant; empty if there are none. */
	content(id: string): Promise<RecentContent>;
	/**
	 * One atomic change, during which no other tab writes.
	 * @param decide returns the change, given the valid plants
	 * @throws errors of the storage; nothing is changed then
	 */
	change(decide: (stored: readonly RecentPlant[]) => RecentChange): Promise<void>;
}
