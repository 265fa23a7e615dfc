/**
 * The *lod* form: a plant at several levels of detail in one file (MSFT_lod), for engines that choose one by its size
 * in the view. The finest is in the scene, and names the others; readers without the extension show only the finest.
 */
import type { Part } from "../plant/part";
import type { About } from "./about";
import { exportGlb } from "./glb";

/** Makes a plant at several levels of detail, from near to far. */
export type Levels = () => Promise<readonly (readonly Part[])[]>;

/**
 * The least share of the view's area for each level; the last level is shown until it is invisible. Squares of the
 * shares of the view's height at which stands change levels (render/level_choice.ts), rounded.
 */
const COVERAGE = [0.5, 0.07, 0.007, 0];

/** Writes the file: plain glTF for readers without the extension, which is not required. */
export async function lodGlb(levels: Levels, about: About): Promise<Uint8Array<ArrayBuffer>> {
	// Skip empty meshes: a tree without leaves or blossoms has some.
	const drawn = ({ shape }: Part) => shape !== undefined && shape.mesh.indices.length > 0;
	const all = (await levels()).map((parts) => parts.filter(drawn)).filter((parts) => parts.length > 0);
	const parts = all.map((children, level): Part => ({ name: `Level ${level}`, children }));
	const coverage = [...COVERAGE.slice(0, Math.max(0, all.length - 1)), 0];
	return exportGlb(parts, about, { coverage });
}
