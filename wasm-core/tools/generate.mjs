/**
 * `npm run generate`: writes the code that is made from tables and texts. With `--check` it writes nothing and fails if a
 * file is not what its table says. `npm run generate -- --help` lists what else is generated, by name.
 */
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { outputs as grammars } from "./generate/grammars.mjs";
import { outputs as measures } from "./generate/measures.mjs";
import { outputs as parameters } from "./generate/parameters.mjs";
import { outputs as texts } from "./generate/texts.mjs";
import { outputs as turtle } from "./generate/turtle.mjs";
import { outputs as words } from "./generate/words.mjs";
import { repository } from "./repository.mjs";
import { command } from "./setup.mjs";
import { runTask } from "./tasks.mjs";

/** Makers of generated files; each gives `{ path, text }[]`, paths from the repository's root. */
const makers = [parameters, measures, grammars, texts, turtle, words];

/** Documentation pages are made by `npm run docs`, code by `npm run generate`. */
const isPage = (path) => path.endsWith(".md");

/**
 * Brings generated files up to date and returns the paths of those that were not.
 *
 * @param {{ write: boolean, only?: "code" | "pages" }} options only: the other files are left as they are
 */
export function generate({ write, only }) {
	const all = makers.flatMap((outputs) => outputs());
	return update(only ? all.filter(({ path }) => isPage(path) === (only === "pages")) : all, { write });
}

/**
 * Writes files that are not as they should be, or only returns their paths.
 *
 * @param {{ path: string, text: string }[]} files paths from the root of the repository
 * @param {{ write: boolean }} options
 */
export function update(files, { write }) {
	const stale = files.filter(({ path, text }) => {
		const file = join(repository, path);
		return !existsSync(file) || readFileSync(file, "utf8") !== text;
	});
	for (const { path, text } of write ? stale : []) {
		mkdirSync(dirname(join(repository, path)), { recursive: true });
		writeFileSync(join(repository, path), text);
	}
	return stale.map(({ path }) => path);
}

/** Prints what was written, or what is stale, which is an error. */
export function reportUpdate(stale, { write, script }) {
	for (const path of stale) console.error(write ? `wrote ${path}` : `${path} is stale: run \`npm run ${script}\`.`);
	if (!write && stale.length > 0) process.exitCode = 1;
}

/** @type {Record<string, import("./tasks.mjs").Task>} */
const tasks = {
	tables: {
		about: "code from the tables and texts in wasm-core/ (default); `--check` only compares",
		words: "[--check]",
		run: (words) => {
			const write = !words.includes("--check");
			reportUpdate(generate({ write, only: "code" }), { write, script: "generate" });
		},
	},
	leaves: {
		about: "the leaves of other plants, grown with the leaf model",
		run: async () => (await import("./generate/leaves.mjs")).generateLeaves(),
	},
	links: {
		about: "lists frozen links with their fingerprints (docs/links.md)",
		words: "[LINK …]",
		run: (words) => {
			const script = join(repository, "tests/golden/links/add_links.mjs");
			process.exitCode = spawnSync(process.execPath, [script, ...words], { stdio: "inherit" }).status ?? 1;
		},
	},
};

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const words = process.argv.slice(2);
	await command(() => runTask("generate", tasks, words, { standard: () => tasks.tables.run(words) }));
}
