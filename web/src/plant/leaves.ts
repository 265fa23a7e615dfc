/** The baked leaves by name, each fetched with the first plant that has it. */
import { type AttachedLeaf, type LeafFile, readLeaf } from "./leaf";

/** Loaders of the leaves by path. */
const FILES = import.meta.glob<LeafFile>("./leaves/*.json", { import: "default" });

const fetched = new Map<string, AttachedLeaf>();

/** Fetches a leaf; rejects where that fails, and the next call tries again. Does nothing for an unknown name. */
export async function fetchBakedLeaf(name: string): Promise<void> {
	const file = FILES[`./leaves/${name}.json`];
	if (fetched.has(name) || !file) return;
	fetched.set(name, await readLeaf(await file()));
}

/** Returns the leaf; undefined before it has been fetched. */
export const fetchedLeaf = (name: string): AttachedLeaf | undefined => fetched.get(name);
