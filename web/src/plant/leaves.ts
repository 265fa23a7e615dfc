/** The baked leaves by name: each fetched when a plant first bears it. */
import { type BorneLeaf, type LeafFile, readLeaf } from "./leaf";

const FILES = {
	beech: () => import("./leaves/beech.json"),
	birch: () => import("./leaves/birch.json"),
	grapevine: () => import("./leaves/grapevine.json"),
	lime: () => import("./leaves/lime.json"),
	maple: () => import("./leaves/maple.json"),
	oak: () => import("./leaves/oak.json"),
	willow: () => import("./leaves/willow.json"),
} as const satisfies Record<string, () => Promise<{ default: LeafFile }>>;

const fetched = new Map<string, BorneLeaf>();

/** Fetches one; rejects where that fails, and tries again with the next call. A name that there is none of is nothing to fetch. */
export async function fetchBakedLeaf(name: string): Promise<void> {
	if (fetched.has(name) || !isBaked(name)) return;
	fetched.set(name, await readLeaf((await FILES[name]()).default));
}

/** Undefined before it is there. */
export const fetchedLeaf = (name: string): BorneLeaf | undefined => fetched.get(name);

function isBaked(name: string): name is keyof typeof FILES {
	return Object.hasOwn(FILES, name);
}
