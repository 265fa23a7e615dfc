/** Whether what was made from files is still what they would make. */
import { existsSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { repository } from "./repository.mjs";

/** Every file below folders, and single files, from the repository's root; without folders, whose times change with the files in them. */
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
 * Made from the same files, and after the last of them changed: a file that moved in may be older than what is there.
 *
 * @param {string} made what was made last
 * @param {string} stamp where `remember` wrote what it was made from
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
