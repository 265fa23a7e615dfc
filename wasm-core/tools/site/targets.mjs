/**
 * Where the links and pictures of docs/ lead on the documentation site. Paths are relative to the repository and have
 * slashes.
 */
import { posix } from "node:path";

const { dirname, join, relative } = posix;

/** The folder of the site for copies of files that pages link to and that are not in docs/: grammars, the licence. */
const COPIES = "files";

/** The page of the site that a file of docs/ becomes: `docs/models/tree/tree.md` → `models/tree/tree.html`. */
export const pageOf = (file) => relative("docs", file).replace(/\.md$/, ".html");

/** The way from a page of the site to its top folder: "" or `../../`. */
export const upFrom = (page) => "../".repeat(page.split("/").length - 1);

/**
 * Translates a relative address in a file of docs/ into one for the page of the site.
 *
 * @param {string} address as written in Markdown
 * @param {string} file the file of docs/ that has it
 * @param {(path: string) => "file" | "folder" | "none"} kindOf the kind of a path of the repository
 * @returns {{ address: string, page?: string, copy?: string } | undefined} `page`: the file of docs/ that it leads to; `copy`: a file
 *   of the repository that the site needs; undefined: there is nothing on the site to lead to, such as a folder of sources
 */
export function translate(address, file, kindOf) {
	if (/^([a-z][a-z+.-]*:|#|$)/i.test(address)) return { address };
	const [, path, rest] = /^([^?#]*)(.*)$/.exec(address) ?? [];
	const target = join(dirname(file), decodeURI(path));
	const page = pageOf(file);
	const to = (goal) => encodeURI(relative(dirname(page), goal)) + rest;
	if (target.startsWith("docs/") && kindOf(target) === "file") {
		const goal = { address: to(pageOf(target)) };
		return target.endsWith(".md") ? { ...goal, page: target } : goal;
	}
	// The app's folder is the one above the site.
	if (target.startsWith("public/")) return { address: to(`../${target.slice("public/".length)}`) };
	if (kindOf(target) === "folder") return undefined;
	// Reported by the check of links.
	if (kindOf(target) === "none") return { address };
	// Browsers show the files instead of downloading them.
	const copy = join(COPIES, `${target}.txt`);
	return { address: to(copy), copy: target };
}
