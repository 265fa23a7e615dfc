/** What changed since the last release or the merge base (wasm-core/tools/changes.mjs), as rooms and tests. */
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { changedFiles } from "../../wasm-core/tools/changes.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";

const foldersIn = (place) =>
	existsSync(join(repository, place))
		? readdirSync(join(repository, place), { withFileTypes: true })
				.filter((entry) => entry.isDirectory())
				.map(({ name }) => name)
		: [];

/** All rooms of the core: the folders of wasm-core/src, with each model in place of `models`. */
export const coreRooms = () => [
	...foldersIn("wasm-core/src").filter((name) => name !== "models"),
	...foldersIn("wasm-core/src/models"),
];

/**
 * The rooms of the core whose sources or tests are among the files; all of them where the files are unknown, or where a
 * file changed that concerns every room.
 *
 * @param {string[] | undefined} files
 * @returns {string[]}
 */
export function roomsOf(files) {
	if (!files || files.some((file) => /^wasm-core\/(CMake[^/]*|tools\/native\.cmake)$/.test(file))) return coreRooms();
	const rooms = files.map((file) => /^(?:wasm-core\/src|tests\/core)\/(?:models\/)?([^/]+)\//.exec(file)?.[1]);
	return [...new Set(rooms)].filter((room) => room !== undefined && coreRooms().includes(room)).sort();
}

export const changedRooms = () => roomsOf(changedFiles());
