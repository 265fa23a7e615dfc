/** The game trees with which integrations are tested. */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { unzipSync } from "fflate";
import { must } from "../readers/programs.mjs";
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
export function writeSmallTree(folder) {
	const { files, height } = smallTree();
	return written(join(folder, "small"), files, "tree", height);
}

/**
 * Grows an oak by the command line as an archive for games, and extracts it into a folder.
 * @returns {Promise<TreeFiles>}
 */
export async function growOak(folder) {
	const archive = join(folder, "oak.zip");
	await must(process.execPath, [
		"wasm-core/tools/grow.mjs",
		"growth/oak",
		"--seed",
		"7",
		"--form",
		"game",
		"--out",
		archive,
	]);
	const files = new Map(Object.entries(unzipSync(readFileSync(archive))));
	const { pivots } = JSON.parse(new TextDecoder().decode(files.get("Oak.json")));
	return written(join(folder, "oak"), files, "Oak", pivots.high[1]);
}

/** Writes the files of a tree whose GLB has a name. */
function written(folder, files, name, height) {
	mkdirSync(folder, { recursive: true });
	for (const [file, bytes] of files) writeFileSync(join(folder, file), bytes);
	const others = [...files.keys()].filter((file) => file !== `${name}.glb`);
	return {
		glb: join(folder, `${name}.glb`),
		beside: Object.fromEntries(others.map((file) => [file.replace(`${name}.json`, "tree.json"), join(folder, file)])),
		expected: { levels: 4, shapes: 1, height },
	};
}
