/** The game tree with which integrations are tested. */
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { smallTree } from "./small_tree.mjs";

/**
 * @typedef {object} TreeFiles
 * @property {string} glb path of the GLB
 * @property {Record<string, string>} beside paths of the other files, by their names beside `tree.glb`
 * @property {{ levels: number, shapes: number, height: number }} expected numbers of levels and of collision shapes, and
 *   the height in metres
 */

/**
 * Writes the files of the small tree into a folder.
 * @returns {TreeFiles}
 */
export function gameTree(folder) {
	mkdirSync(folder, { recursive: true });
	const { files, height } = smallTree();
	for (const [name, bytes] of files) writeFileSync(join(folder, name), bytes);
	const others = [...files.keys()].filter((name) => name !== "tree.glb");
	return {
		glb: join(folder, "tree.glb"),
		beside: Object.fromEntries(others.map((name) => [name, join(folder, name)])),
		expected: { levels: 4, shapes: 1, height },
	};
}
