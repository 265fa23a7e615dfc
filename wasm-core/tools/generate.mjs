/**
 * Writes every file that is made from a table: `node wasm-core/tools/generate.mjs`. With `--check` it writes nothing and
 * fails when a committed file is not what its table says.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { outputs as parameters } from "./generate/parameters.mjs";
import { repository } from "./repository.mjs";

/** Makers of generated files; each gives `{ path, text }[]`, paths from the repository's root. */
async function makers() {
	const turtle = new URL("./generate/turtle.mjs", import.meta.url);
	return existsSync(fileURLToPath(turtle)) ? [parameters, (await import(turtle)).outputs] : [parameters];
}

/** Brings the generated files up to date and returns the paths of those that were not. */
export async function generate({ write }) {
	const stale = [];
	for (const outputs of await makers()) {
		for (const { path, text } of await outputs()) {
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
	const stale = await generate({ write: !check });
	for (const path of stale) console.error(check ? `${path} is stale: run \`npm run generate\`.` : `wrote ${path}`);
	if (check && stale.length > 0) process.exitCode = 1;
}
