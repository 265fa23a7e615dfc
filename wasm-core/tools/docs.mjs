/**
 * `npm run docs [-- NAME] [-- --check]`: brings the pages of the documentation that programs write up to date and
 * builds the documentation site from all pages; with a name only that task. With `--check` it writes nothing and fails
 * if a page is not up to date. Pictures are made by `npm run pictures`.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { buildCore } from "./core.mjs";
import { replaceSection } from "./generate/section.mjs";
import { generate, reportUpdate, update } from "./generate.mjs";
import { makePackage } from "./package/make.mjs";
import { repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";
import { runTask } from "./tasks.mjs";

/** Brings the table in docs/measuring.md up to date. */
async function fitPage() {
	await setUp("core");
	await buildCore();
	const { fitTable } = await import(pathToFileURL(join(repository, "tests/bench/fit.mjs")).href);
	const path = "docs/measuring.md";
	return [{ path, text: replaceSection(readFileSync(join(repository, path), "utf8"), "fit", fitTable()) }];
}

/** Brings docs/api up to date, from the comments of the package's exports. */
async function apiPages() {
	await setUp("core");
	const { pages } = await makePackage();
	return Object.entries(pages).map(([name, text]) => ({ path: `docs/api/${name}.md`, text }));
}

/** @param {(options: { write: boolean }) => string[] | Promise<string[]>} bringUpToDate */
const task = (about, bringUpToDate) => ({
	about,
	words: "[--check]",
	run: async (/** @type {string[]} */ words) => {
		const write = !words.includes("--check");
		reportUpdate(await bringUpToDate({ write }), { write, script: "docs" });
	},
});

/** @type {Record<string, import("./tasks.mjs").Task>} */
const tasks = {
	tables: task("the turtle's symbols, and parameters, measures and presets of each model", ({ write }) =>
		generate({ write, only: "pages" }),
	),
	figures: task("numbers in the pages: counts, and sizes of what is built here", async (options) => {
		await setUp("core");
		const { pagesWithFigures } = await import(new URL("../../tests/sizes/figures.mjs", import.meta.url).href);
		return update(await pagesWithFigures(), options);
	}),
	fit: task("the table in docs/measuring.md: how closely bunches follow their handles", async (options) =>
		update(await fitPage(), options),
	),
	api: task("docs/api, the interface of the package, from its comments", async (options) =>
		update(await apiPages(), options),
	),
	site: {
		about: "the documentation site, in build/docs-site; `npm run build` puts it beside the app",
		run: async () => {
			await setUp("core");
			const { buildSite } = await import("./site/build.mjs");
			const before = performance.now();
			const folder = await buildSite();
			console.log(`${folder}/index.html is up to date (${((performance.now() - before) / 1000).toFixed(1)} s).`);
		},
	},
};

const words = process.argv.slice(2);
const all = async () => {
	for (const [name, { run }] of Object.entries(tasks)) {
		// There is no committed site to compare with.
		if (name !== "site" || !words.includes("--check")) await run(words);
	}
};
await command(() => runTask("docs", tasks, words, { standard: all }));
