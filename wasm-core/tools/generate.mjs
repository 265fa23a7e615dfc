/**
 * Writes every file that is made from a table: `node wasm-core/tools/generate.mjs`. With `--check` it writes nothing and
 * fails when a committed file is not what its table says.
 */
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

/** Makers of generated files; each gives `{ path, text }[]`, paths from the repository's root. */
const makers = [parameters, measures, grammars, texts, turtle, words];

/** Brings the generated files up to date and returns the paths of those that were not. */
export function generate({ write }) {
	const stale = [];
	for (const outputs of makers) {
		for (const { path, text } of outputs()) {
			const file = join(repository, path);
			if (existsSync(file) && readFileSync(file, "utf8") === text) continue;
			stale.push(path);
			if (!write) continue;
			mkdirSync(dirname(file), { recursive: true });
			writeFileSync(file, text);
		}
	}
	return stale;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const check = process.argv.includes("--check");
	const stale = generate({ write: !check });
	for (const path of stale) console.error(check ? `${path} is stale: run \`npm run generate\`.` : `wrote ${path}`);
	if (check && stale.length > 0) process.exitCode = 1;
}
