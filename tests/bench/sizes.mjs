/** How much of dist/ a first load brings over the wire: the page and all that it asks for before a person does anything. */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

export const gzipped = (path) => gzipSync(readFileSync(path), { level: 9 }).length;

/** @param {string[]} requested paths below dist/ that the page asked for */
export function firstLoad(dist, requested) {
	return requested.map((path) => ({ path, bytes: existsSync(join(dist, path)) ? gzipped(join(dist, path)) : 0 }));
}

export function filesEndingIn(folder, ending) {
	return readdirSync(folder, { recursive: true })
		.map(String)
		.filter((path) => path.endsWith(ending));
}
