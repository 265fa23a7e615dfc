/** Checks the links of built pages. */
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, relative } from "node:path";

const withoutCode = (html) => html.replace(/<pre[\s\S]*?<\/pre>/g, "");
const addressesOf = (html) =>
	[...withoutCode(html).matchAll(/\s(?:href|src|poster)="([^"]*)"/g)].map(([, address]) =>
		address.replaceAll("&amp;", "&"),
	);
const anchorsOf = (html) => new Set([...html.matchAll(/\sid="([^"]*)"/g)].map(([, id]) => id));

/**
 * Lists the links of all pages that lead to no file and no anchor.
 * @param {string} folder of the built site
 * @param {(path: string) => boolean} isInApp whether the app has a file: its folder is the one above the site's
 * @returns {string[]} a line for each address that leads nowhere
 */
export function brokenLinks(folder, isInApp) {
	const pages = readdirSync(folder, { recursive: true, encoding: "utf8" })
		.filter((path) => path.endsWith(".html") && !path.startsWith("pagefind"))
		.sort();
	const texts = new Map(pages.map((page) => [page, readFileSync(join(folder, page), "utf8")]));
	const anchors = new Map([...texts].map(([page, html]) => [page, anchorsOf(html)]));
	const isThere = (page, address) => {
		const [path, anchor] = address.split(/\?[^#]*#?|#/);
		const goal = path ? relative(folder, join(folder, dirname(page), decodeURI(path))) : page;
		if (goal.startsWith("..")) return isInApp(relative("..", goal));
		const file = join(folder, goal);
		if (!existsSync(file) || !statSync(file).isFile()) return false;
		return !anchor || (anchors.get(goal)?.has(decodeURIComponent(anchor)) ?? false);
	};
	return [...texts].flatMap(([page, html]) =>
		addressesOf(html)
			.filter((address) => !/^[a-z][a-z+.-]*:/i.test(address) && !isThere(page, address))
			.map((address) => `${page}: ${address}`),
	);
}
