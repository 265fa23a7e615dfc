/** How much of dist/ a first load brings over the wire: the page and all that it asks for until its plant is drawn. */
import { readFileSync } from "node:fs";
import { extname, join } from "node:path";
import { gzipSync } from "node:zlib";

export const gzipped = (path) => gzipSync(readFileSync(path), { level: 9 }).length;

/**
 * @param {string} dist
 * @param {string[]} requested paths below dist/ that the page asked for
 * @throws where one of them is not there
 */
export function firstLoad(dist, requested) {
	return requested.map((path) => ({ path, bytes: gzipped(join(dist, path)) }));
}

const KINDS = { ".woff2": "fonts", ".webp": "pictures" };

/**
 * What a first load comes to by kind: `code` is the page, its styles and scripts, and the core.
 * @param {{ path: string, bytes: number }[]} files
 */
export function byKind(files) {
	const sums = { code: 0, fonts: 0, pictures: 0 };
	for (const { path, bytes } of files) sums[KINDS[extname(path)] ?? "code"] += bytes;
	return sums;
}
