/** Transfer sizes of files in dist/, and of the files that a page has fetched. */
import { readFileSync } from "node:fs";
import { extname, join } from "node:path";
import { gzipSync } from "node:zlib";

export const gzipped = (path) => gzipSync(readFileSync(path), { level: 9 }).length;

/**
 * The files that a page has fetched, with their sizes.
 * @param {string} dist
 * @param {string[]} requested paths below dist/ that the page requested
 * @throws where one of them does not exist
 */
export function firstLoad(dist, requested) {
	return requested.map((path) => ({ path, bytes: gzipped(join(dist, path)) }));
}

const KINDS = { ".wasm": "core", ".woff2": "fonts", ".webp": "pictures" };

/**
 * The size of fetched files by kind: `code` is the page with its styles and scripts, `core` the models' WebAssembly.
 * @param {{ path: string, bytes: number }[]} files
 */
export function byKind(files) {
	const sums = { code: 0, core: 0, fonts: 0, pictures: 0 };
	for (const { path, bytes } of files) sums[KINDS[extname(path)] ?? "code"] += bytes;
	return sums;
}
