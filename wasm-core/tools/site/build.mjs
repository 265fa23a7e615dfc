/**
 * Builds the documentation site: docs/ as static pages that work in any folder of any host, with a search that needs no
 * server. The app's build puts it beside the app (web/docs_site.mjs).
 */
import { copyFileSync, cpSync, existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { filesIn, isFresh, remember } from "../fresh.mjs";
import { withLock } from "../lock.mjs";
import { buildFolder, repository } from "../repository.mjs";
import { brokenLinks } from "./check_links.mjs";
import { pageOf, translate, upFrom } from "./targets.mjs";

export const siteFolder = join(buildFolder, "docs-site");
const stamp = join(buildFolder, "docs-site.stamp");
/** Layout, styles and script of the pages. */
const SOURCES = "web/docs_site";
/** The app's colours and fonts. */
const TOKENS = "web/src/app/style/tokens.css";

const read = (path) => readFileSync(join(repository, path), "utf8");
const toFile = (path) => join(siteFolder, path);

function kindOf(path) {
	const file = join(repository, path);
	if (!existsSync(file)) return "none";
	return statSync(file).isFile() ? "file" : "folder";
}

/** The title of a page: its first heading, without markup. */
const titleOf = (markdown) => (/^# (.+)$/m.exec(markdown)?.[1] ?? "Panicle").replace(/[`*]/g, "");

/** The pages in the order of the navigation, by section: paths below docs/ and titles. */
export function navigation() {
	/** @type {{ title: string, pages: string[] }[]} */
	const sections = JSON.parse(read(`${SOURCES}/pages.json`));
	return sections.map(({ title, pages }) => ({
		title,
		pages: pages.map((path) => ({ address: pageOf(`docs/${path}`), title: titleOf(read(`docs/${path}`)) })),
	}));
}

/** The policy of the app's page, which these pages have, too. */
const policy = () => /Security-Policy" content="([^"]+)"/.exec(read("web/index.html"))?.[1];

/** Headings of the second level, for the list of a page's contents. */
const headings = (html) =>
	[...html.matchAll(/<h2 id="([^"]*)"[^>]*>([\s\S]*?)<\/h2>/g)].map(([, id, title]) => ({
		id,
		title: title.replace(/<[^>]+>/g, ""),
	}));

/**
 * The place of a page in the navigation: its section, and the pages before and after it.
 * @param {ReturnType<typeof navigation>} sections
 */
function placeOf(sections, address) {
	const pages = sections.flatMap((section) => section.pages);
	const index = pages.findIndex((page) => page.address === address);
	if (index < 0) return {};
	const section = sections.find((each) => each.pages.includes(pages[index]));
	return { section: section?.title, previous: pages[index - 1], next: pages[index + 1] };
}

/** A plant shows the picture inside of it until it has grown. */
const withPosters = (html) =>
	html.replace(/(<panicle-specimen\b[^>]*)>(\s*(?:<p>)?(?:<a[^>]*>)?<img src="([^"]+)")/g, '$1 poster="$3">$2');

/** Renders the pages into the folder of the site. */
async function renderPages() {
	const [{ default: Eleventy }, { prepareMarkdown }] = await Promise.all([
		import("@11ty/eleventy"),
		import("./markdown.mjs"),
	]);
	/** @type {Set<string>} */
	const copies = new Set();
	const lead = (address, file) => {
		const found = translate(address, file, kindOf);
		if (found?.copy) copies.add(found.copy);
		return found?.page ? { ...found, title: titleOf(read(found.page)) } : found;
	};
	const eleventy = new Eleventy("docs", siteFolder, {
		quietMode: true,
		configPath: false,
		/** Configures Eleventy: pages are Markdown in one layout, and links are relative. */
		config: (config) => {
			config.setIncludesDirectory(`../${SOURCES}`);
			config.setTemplateFormats(["md"]);
			config.addGlobalData("layout", "page.njk");
			config.addGlobalData("sections", navigation);
			config.addGlobalData("policy", policy);
			config.addGlobalData("eleventyComputed", {
				permalink: ({ page }) => pageOf(page.inputPath.replace(/^\.\//, "")),
				title: ({ page }) => titleOf(page.rawInput),
				up: ({ page }) => upFrom(pageOf(page.inputPath.replace(/^\.\//, ""))),
				address: ({ page }) => pageOf(page.inputPath.replace(/^\.\//, "")),
			});
			config.addFilter("headings", headings);
			config.addFilter("placeOf", placeOf);
			config.addFilter("isIn", (pages, address) => pages.some((page) => page.address === address));
			config.addTransform("posters", withPosters);
			config.amendLibrary("md", (md) => prepareMarkdown(md, lead));
			return { markdownTemplateEngine: false };
		},
	});
	await eleventy.write();
	for (const copy of copies) {
		const to = toFile(`files/${copy}.txt`);
		mkdirSync(dirname(to), { recursive: true });
		copyFileSync(join(repository, copy), to);
	}
}

/** Copies pictures, styles and scripts. */
function copyAssets() {
	const isPage = (path) => path.endsWith(".md");
	cpSync(join(repository, "docs"), siteFolder, { recursive: true, filter: (path) => !isPage(path) });
	for (const name of ["search.svg", "theme.js"]) copyFileSync(join(repository, SOURCES, name), toFile(name));
	// The fonts are in the app's folder, one above.
	const tokens = read(TOKENS).replaceAll('url("/fonts/', 'url("../fonts/');
	const search = readFileSync(toFile("pagefind/pagefind-component-ui.css"), "utf8");
	writeFileSync(toFile("site.css"), [tokens, search, read(`${SOURCES}/site.css`)].join("\n"));
	// The command palette of the app lists the pages.
	writeFileSync(toFile("pages.json"), JSON.stringify(navigation()));
}

/** Writes the index that the search fetches in parts, and its script. */
async function indexPages() {
	const pagefind = await import("pagefind");
	const { index, errors } = await pagefind.createIndex({ keepIndexUrl: true });
	if (!index) throw new Error(errors.join("\n"));
	const added = await index.addDirectory({ path: siteFolder, glob: "**/*.html" });
	const written = await index.writeFiles({ outputPath: toFile("pagefind") });
	await pagefind.close();
	const problems = [...added.errors, ...written.errors];
	if (problems.length > 0) throw new Error(problems.join("\n"));
}

/** All files that the site is made from, but for the few single files that pages link to. */
const inputs = () =>
	filesIn("docs", SOURCES, TOKENS, "wasm-core/tools/site", "wasm-core/grammars", "web/index.html", "package-lock.json");

/**
 * Builds the site unless its inputs are unchanged.
 * @throws Error for links that lead nowhere
 */
async function build() {
	const files = inputs();
	if (isFresh(stamp, stamp, files)) return;
	rmSync(stamp, { force: true });
	rmSync(siteFolder, { recursive: true, force: true });
	await renderPages();
	await indexPages();
	copyAssets();
	const isInApp = (path) =>
		["", "index.html", "panicle.js"].includes(path) || existsSync(join(repository, "public", path));
	const broken = brokenLinks(siteFolder, isInApp);
	if (broken.length > 0) throw new Error(`Links of docs/ that lead nowhere on the site:\n${broken.join("\n")}`);
	remember(stamp, files);
}

/**
 * Builds the site where something has changed since the last build.
 * @returns {Promise<string>} its folder
 * @throws Error where a link or a picture leads nowhere
 */
export async function buildSite() {
	await withLock(`${siteFolder}.lock`, build);
	return siteFolder;
}
