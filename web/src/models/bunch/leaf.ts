/** The leaf on the cane: the grapevine's, fetched when a bunch first has leaves. */
import type { Block } from "../../core/container";
import { type BorneLeaf, leafBlocks } from "../../plant/leaf";
import { fetchBakedLeaf, fetchedLeaf } from "../../plant/leaves";

const CANE = "grapevine";

/** Fetches it; rejects where that fails, and tries again with the next call. */
export const fetchLeaf = (): Promise<void> => fetchBakedLeaf(CANE);

/** Undefined before it is there. */
export const leafOnCane = (): BorneLeaf | undefined => fetchedLeaf(CANE);

/** As a request has it; nothing before it is there. */
export function caneLeafBlocks(): Block[] {
	const leaf = leafOnCane();
	return leaf ? leafBlocks(leaf) : [];
}
