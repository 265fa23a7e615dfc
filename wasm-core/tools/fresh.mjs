/** Checks whether a generated file or folder is up to date with the files that it was made from. */
import { existsSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { repository } from "./repository.mjs";

/**
 * Lists files, by absolute paths: single files and every file below folders, each given from the repository's root.
 * Folders themselves are left out, because their times change with the files in them.
 */
export function filesIn(...places) {
	return places
		.map((place) => join(repository, place))
		.flatMap((place) =>
			statSync(place).isFile()
				? [place]
				: readdirSync(place, { recursive: true, withFileTypes: true })
						.filter((entry) => entry.isFile())
						.map((entry) => join(entry.parentPath, entry.name)),
		)
		.sort();
}

const listOf = (inputs) => inputs.map((file) => relative(repository, file)).join("\n");

/**
 * Returns whether the output was made from the same list of files, after the last of them changed. The list is
 * compared as well, because a file that was moved here may be older than the output.
 *
 * @param {string} made the output that is written last
 * @param {string} stamp the file in which `remember` lists the inputs
 * @param {string[]} inputs
 */
export function isFresh(made, stamp, inputs) {
	if (!existsSync(made) || !existsSync(stamp) || readFileSync(stamp, "utf8") !== listOf(inputs)) return false;
	const when = statSync(made).mtimeMs;
	return inputs.every((file) => statSync(file).mtimeMs < when);
}

export function remember(stamp, inputs) {
	writeFileSync(stamp, listOf(inputs));
}
