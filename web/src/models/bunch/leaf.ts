/** The leaf on the cane: the grapevine's, fetched when a bunch first has leaves. */
import type { Block } from "../../core/container";
import type { BorneLeaf } from "../../plant/leaf";

let fetched: BorneLeaf | undefined;

/** Fetches it; rejects where that fails, and tries again with the next call. */
export async function fetchLeaf(): Promise<void> {
	if (fetched) return;
	const [{ readLeaf }, file] = await Promise.all([
		import("../../plant/leaf"),
		import("../../plant/leaves/grapevine.json"),
	]);
	fetched = await readLeaf(file.default);
}

/** Undefined before it is there. */
export const leafOnCane = (): BorneLeaf | undefined => fetched;

/** As a request has it; nothing before it is there. */
export function leafBlocks(): Block[] {
	if (!fetched) return [];
	const { points, between, uvs, indices } = fetched;
	return [
		{ name: "leaf.points", data: points, width: 2 },
		{ name: "leaf.between", data: between },
		{ name: "leaf.uvs", data: uvs, width: 2 },
		{ name: "leaf.triangles", data: indices, width: 3 },
	];
}
