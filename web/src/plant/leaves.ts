/** The baked leaves by name: each fetched when a plant first bears it. */
import { type AttachedLeaf, type LeafFile, readLeaf } from "./leaf";

/** How each is fetched, by where it lies. */
const FILES = import.meta.glob<LeafFile>("./leaves/*.json", { import: "default" });

const fetched = new Map<string, AttachedLeaf>();

/** Fetches one; rejects where that fails, and tries again with the next call. A name that there is none of is nothing to fetch. */
export async function fetchBakedLeaf(name: string): Promise<void> {
	const file = FILES[`./leaves/${name}.json`];
	if (fetched.has(name) || !file) return;
	fetched.set(name, await readLeaf(await file()));
}

/** Undefined before it is there. */
export const fetchedLeaf = (name: string): AttachedLeaf | undefined => fetched.get(name);
