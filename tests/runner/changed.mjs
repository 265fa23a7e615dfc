/** The rooms of the core that a change concerns. */
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { changedFiles, gateBase } from "../../wasm-core/tools/changes.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";

/** Names of the folders in a folder of the repository; none where that does not exist. */
export const foldersIn = (place) =>
	existsSync(join(repository, place))
		? readdirSync(join(repository, place), { withFileTypes: true })
				.filter((entry) => entry.isDirectory())
				.map(({ name }) => name)
		: [];

/** All rooms of the core: the folders of wasm-core/src, with each model in place of `models`. */
export const coreFolders = () => [
	...foldersIn("wasm-core/src").filter((name) => name !== "models"),
	...foldersIn("wasm-core/src/models"),
];

/** Files that affect every room: the build, and helpers of all native tests. */
const OF_ALL_ROOMS = /^(wasm-core\/(CMake[^/]*|tools\/native\.cmake)|tests\/core\/[^/]+)$/;
/** Files of one room: sources, tests, grammars, tables. */
const OF_A_ROOM = [
	/^(?:wasm-core\/src|tests\/core)\/(?:models\/)?([^/]+)\//,
	/^wasm-core\/grammars\/([^/]+)\//,
	/^wasm-core\/parameters\/([^/.]+)\./,
];

/** Whether a change of the file can change plants or results of native tests. */
export const isOfCore = (file) => OF_ALL_ROOMS.test(file) || OF_A_ROOM.some((pattern) => pattern.test(file));

/**
 * The rooms of the core whose files are among those that changed; all of them where these are unknown, or where one concerns
 * every room.
 *
 * @param {string[] | undefined} files
 * @returns {string[]}
 */
export function roomsOf(files) {
	const rooms = coreFolders();
	if (!files || files.some((file) => OF_ALL_ROOMS.test(file))) return rooms;
	const named = files.flatMap((file) => OF_A_ROOM.map((pattern) => pattern.exec(file)?.[1])).filter(Boolean);
	return [...new Set(named)].filter((name) => rooms.includes(name)).sort();
}

/** The rooms that the gate sanitizes; all of them without a base to compare with. */
export function changedRooms() {
	const base = gateBase();
	return roomsOf(base && changedFiles({ base }));
}
