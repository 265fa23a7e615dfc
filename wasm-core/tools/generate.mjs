/**
 * Writes every file that is made from a table: `npm run generate`. Source files (`*.generated.hpp`, `*.generated.ts`) lie beside the files
 * that use them and are ignored by git; every command that reads them calls `generateSources` first. Pages of documentation are committed.
 * With `--sources` only source files are written, silently; with `--check` nothing is written and a file that is out of date is an error.
 * Imports no package, so that it runs before `npm ci`.
 */
import {
	existsSync,
	mkdirSync,
	readdirSync,
	readFileSync,
	renameSync,
	rmdirSync,
	rmSync,
	writeFileSync,
} from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { outputs as grammars } from "./generate/grammars.mjs";
import { outputs as measures } from "./generate/measures.mjs";
import { outputs as parameters } from "./generate/parameters.mjs";
import { outputs as texts } from "./generate/texts.mjs";
import { outputs as turtle } from "./generate/turtle.mjs";
import { outputs as words } from "./generate/words.mjs";
import { repository } from "./repository.mjs";

/** Makers of generated files; each returns `{ path, text }[]`, with paths from the repository's root. */
const makers = [parameters, measures, grammars, texts, turtle, words];
/** The folders that hold generated source files. */
const sourceFolders = ["wasm-core/src", "web/src"];

const isSource = (path) => /\.generated\.(hpp|ts)$/.test(path);

/** The source files and pages that the tables make, with their paths from the repository's root. */
export const generatedFiles = () => makers.flatMap((outputs) => outputs());

/** Replaces a file as a whole, so that a program that runs at the same time never reads half of it. */
function replaceFile(file, text) {
	const partial = `${file}.${process.pid}`;
	mkdirSync(dirname(file), { recursive: true });
	writeFileSync(partial, text);
	renameSync(partial, file);
}

/** Brings `files` up to date below `root`. Files with the right text keep their modification time, so that nothing is rebuilt. */
function update(files, { write, root }) {
	const stale = files.filter(({ path, text }) => {
		const file = join(root, path);
		return !existsSync(file) || readFileSync(file, "utf8") !== text;
	});
	if (write) for (const { path, text } of stale) replaceFile(join(root, path), text);
	return stale.map(({ path }) => path);
}

/** Removes `folder` and the folders above it, below `top`, that are empty: the build takes every folder of models for a model. */
function removeEmptyFolders(folder, top) {
	for (let at = folder; at !== top; at = dirname(at)) {
		try {
			rmdirSync(at);
		} catch {
			return; // Not empty, or removed by another process.
		}
	}
}

/** Removes generated source files that no table makes, such as those of a model that was removed. */
function removeOrphans(files, { write, root }) {
	const made = new Set(files.map(({ path }) => join(root, path)));
	return sourceFolders.flatMap((folder) => {
		const top = join(root, folder);
		if (!existsSync(top)) return [];
		const found = readdirSync(top, { recursive: true, encoding: "utf8" }).filter(isSource);
		const orphans = found.filter((name) => !made.has(join(top, name)));
		for (const name of write ? orphans : []) {
			rmSync(join(top, name), { force: true });
			removeEmptyFolders(dirname(join(top, name)), top);
		}
		return orphans.map((name) => `${folder}/${name.replaceAll("\\", "/")}`);
	});
}

/**
 * Brings generated files up to date; takes about 0.1 s when nothing has changed.
 * @param {{ write?: boolean, root?: string, pages?: boolean }} [options] `root` is the folder that is written to; `pages`: pages of
 *   documentation, too
 * @returns {string[]} paths of the files that were written or removed; without `write`, of those that would be
 */
export function generate({ write = true, root = repository, pages = true } = {}) {
	const files = generatedFiles();
	const wanted = pages ? files : files.filter(({ path }) => isSource(path));
	return [...update(wanted, { write, root }), ...removeOrphans(files, { write, root })];
}

/** Brings the source files alone up to date: what a command does before it reads them. */
export const generateSources = () => generate({ pages: false });

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const [check, sources] = ["--check", "--sources"].map((word) => process.argv.includes(word));
	const stale = generate({ write: !check, pages: !sources });
	if (check) for (const path of stale) console.error(`${path} is out of date: run \`npm run generate\`.`);
	else if (!sources) for (const path of stale) console.error(`updated ${path}`);
	if (check && stale.length > 0) process.exitCode = 1;
}
