/**
 * `npm run generate`: writes the code that is made from tables and texts. With `--check` it writes nothing and fails if
 * a file is not what its table says. `npm run generate -- --help` lists what else is generated, by name.
 */
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { generate, update } from "./generate/files.mjs";
import { repository } from "./repository.mjs";
import { command } from "./setup.mjs";
import { runTask } from "./tasks.mjs";

export { generate, update };

/** Prints the files that were written, or those that are out of date, which is an error. */
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
	translation: {
		about: "adds missing texts to web/src/locale/*.json, in English, and removes those that no code uses",
		run: () => {
			const args = ["node_modules/vitest/vitest.mjs", "run", "tests/web/locale/translation.test.ts"];
			const env = { ...process.env, PANICLE_TRANSLATE: "1", PANICLE_CORE: "built" };
			process.exitCode = spawnSync(process.execPath, args, { cwd: repository, env, stdio: "inherit" }).status ?? 1;
		},
	},
	leaves: {
		about: "the leaves of other plants, grown with the leaf model",
		run: async () => (await import("./generate/leaves.mjs")).generateLeaves(),
	},
	links: {
		about: "adds frozen links with their fingerprints (docs/links.md): those given, or all that are missing",
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
