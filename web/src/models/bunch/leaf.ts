/** The leaf on the cane: the grapevine's, fetched when a bunch first has leaves. */
import type { Block } from "../../core/container";
import { type AttachedLeaf, leafBlocks } from "../../plant/leaf";
import { fetchBakedLeaf, fetchedLeaf } from "../../plant/leaves";

const CANE = "grapevine";
/** The same of few triangles and small veins. */
const SKETCH = "grapevine_sketch";

/** Fetches it; rejects where that fails, and tries again with the next call. */
export const fetchLeaf = (): Promise<void> => fetchBakedLeaf(CANE);

/** What shows where it will be. */
export const fetchSketch = (): Promise<void> => fetchBakedLeaf(SKETCH);

/** Its sketch before it is there, and undefined before that. */
export const leafOnCane = (): AttachedLeaf | undefined => fetchedLeaf(CANE) ?? fetchedLeaf(SKETCH);

/** As a request has it; nothing before it is there. */
export function caneLeafBlocks(): Block[] {
	const leaf = leafOnCane();
	// The cane has petioles of its own.
	return leaf ? leafBlocks({ ...leaf, petiole: undefined }) : [];
}
