/** The grapevine leaf on the cane, fetched when a bunch first has leaves. */
import type { Block } from "../../core/container";
import { type AttachedLeaf, leafBlocks } from "../../plant/leaf";
import { fetchBakedLeaf, fetchedLeaf } from "../../plant/leaves";

const CANE = "grapevine";
/** A simplified leaf with few triangles and small veins. */
const SKETCH = "grapevine_sketch";

/** Fetches the leaf; rejects on failure and retries at the next call. */
export const fetchLeaf = (): Promise<void> => fetchBakedLeaf(CANE);

/** Fetches the simplified leaf, which is shown until the full one has been fetched. */
export const fetchSketch = (): Promise<void> => fetchBakedLeaf(SKETCH);

/** Returns the leaf, or its sketch before it has been fetched, or undefined before that. */
export const leafOnCane = (): AttachedLeaf | undefined => fetchedLeaf(CANE) ?? fetchedLeaf(SKETCH);

/** Returns the leaf as blocks of a request; none before it has been fetched. */
export function caneLeafBlocks(): Block[] {
	const leaf = leafOnCane();
	// The cane has petioles of its own.
	return leaf ? leafBlocks({ ...leaf, petiole: undefined }) : [];
}
