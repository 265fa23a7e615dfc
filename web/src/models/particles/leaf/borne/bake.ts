/** The leaves that other plants bear, baked from this model's presets: what `npm run bake` writes and a test compares. */
import type { Core } from "../../../../core/core";
import type { LeafFile } from "../../../../plant/leaf";
import { readLeaf } from "../read_leaf";
import { encodeLeaf } from "../request";
import { leafFromPreset } from "../species";
import { type BorneOptions, borneLeaf } from "./borne_leaf";

interface Baked extends BorneOptions {
	/** Triangles of the blade before it is made light, against the core's own choice. */
	detail: number;
}

/** By preset. */
const BAKED: Readonly<Record<string, Baked>> = {
	grapevine: { detail: 0.25, cells: 20, pixels: 512 },
};

/** The presets that are baked. */
export const BAKED_LEAVES = Object.keys(BAKED);

/** Grows a preset and bakes it: the same core gives the same file. */
export function bakeLeaf(core: Core, preset: string): LeafFile {
	const { detail, ...options } = BAKED[preset];
	const specimen = leafFromPreset(preset);
	const leaf = readLeaf(core.grow(encodeLeaf(specimen, { detail, sky: false, measures: false })));
	return borneLeaf(leaf, specimen.parameters.length, `leaf/${preset}`, options);
}
