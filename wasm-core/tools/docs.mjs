/**
 * `npm run docs [-- NAME] [-- --check]`: brings the pages of the documentation that programs write up to date: all, or those of
 * one task. With `--check` it writes nothing and fails if a page is not up to date. Pictures are made by `npm run pictures`.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { buildCore } from "./core.mjs";
import { generate, reportUpdate, update } from "./generate.mjs";
import { makePackage } from "./package/make.mjs";
import { repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";
import { runTask } from "./tasks.mjs";

/** In docs/fit.md, around the table. */
const BEGIN = "<!-- made by npm run docs -- fit -->";
const END = "<!-- end -->";

/** docs/fit.md with its table made anew. */
async function fitPage() {
	await setUp("core");
	await buildCore();
	const { fitTable } = await import(pathToFileURL(join(repository, "tests/bench/fit.mjs")).href);
	const page = readFileSync(join(repository, "docs/fit.md"), "utf8");
	const [before, after] = [page.indexOf(BEGIN), page.indexOf(END)];
	if (before < 0 || after < before) throw new Error(`docs/fit.md lacks ${BEGIN} or ${END}`);
	return [{ path: "docs/fit.md", text: `${page.slice(0, before)}${BEGIN}\n\n${fitTable()}\n\n${page.slice(after)}` }];
}

/** docs/api, from the comments of the package. */
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
	fit: task("the table in docs/fit.md: how closely bunches follow their handles", async (options) =>
		update(await fitPage(), options),
	),
	api: task("docs/api, the interface of the package, from its comments", async (options) =>
		update(await apiPages(), options),
	),
};

const words = process.argv.slice(2);
const all = async () => {
	for (const { run } of Object.values(tasks)) await run(words);
};
await command(() => runTask("docs", tasks, words, { standard: all }));
