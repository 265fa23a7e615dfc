/**
 * The *lod* form: a plant for several distances in one file (MSFT_lod), for engines that show of it what its size in the view is worth.
 * The finest stands in the scene, and names the others; who does not know the extension shows just that.
 */
import type { Part } from "../plant/part";
import type { About } from "./about";
import { exportGlb } from "./glb";

/** A plant for several distances, from near to far. */
export type Levels = () => Promise<readonly (readonly Part[])[]>;

/**
 * Of the view's area, what a plant covers where each level still does, the last until it cannot be seen: squares of the shares of its
 * height at which stands change (models/stand/render/level_choice.ts), rounded.
 */
const COVERAGE = [0.5, 0.07, 0.007, 0];

/** The file: plain glTF for who does not know the extension, which asks for nothing. */
export async function lodGlb(levels: Levels, about: About): Promise<Uint8Array<ArrayBuffer>> {
	// A tree without leaves or blossoms has meshes of none.
	const drawn = ({ shape }: Part) => shape !== undefined && shape.mesh.indices.length > 0;
	const all = (await levels()).map((parts) => parts.filter(drawn)).filter((parts) => parts.length > 0);
	const parts = all.map((children, level): Part => ({ name: `Level ${level}`, children }));
	const coverage = [...COVERAGE.slice(0, Math.max(0, all.length - 1)), 0];
	return exportGlb(parts, about, { coverage });
}
