/**
 * The files that are made from tables and texts: code (`*.generated.hpp`, `*.generated.ts`), which is written beside
 * the files that use it and is ignored by git, and pages of documentation, which are committed. Imports no package:
 * every command that reads generated code calls `generateCode` first, before packages are installed.
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
import { repository } from "../repository.mjs";
import { outputs as grammars } from "./grammars.mjs";
import { outputs as measures } from "./measures.mjs";
import { outputs as messagePage } from "./message_page.mjs";
import { outputs as messages } from "./messages.mjs";
import { outputs as parameters } from "./parameters.mjs";
import { outputs as texts } from "./texts.mjs";
import { outputs as turtle } from "./turtle.mjs";
import { outputs as words } from "./words.mjs";

/** Makers of generated files; each returns `{ path, text }[]`, with paths from the repository's root. */
const makers = [parameters, measures, grammars, messages, messagePage, texts, turtle, words];
/** The folders that hold generated code. */
const codeFolders = ["wasm-core/src", "web/src"];

const isCode = (path) => /\.generated\.(hpp|ts)$/.test(path);

/** The code and the pages as the tables make them now, with their paths from the repository's root. */
export const generatedFiles = () => makers.flatMap((outputs) => outputs());

/** Replaces a file as a whole, so that a program that runs at the same time never reads half of it. */
function replaceFile(file, text) {
	const partial = `${file}.${process.pid}`;
	mkdirSync(dirname(file), { recursive: true });
	writeFileSync(partial, text);
	renameSync(partial, file);
}

/**
 * Brings files up to date, or only compares them. A file with the right text keeps its modification time, so that nothing is rebuilt.
 * @param {{ path: string, text: string }[]} files paths from the root
 * @param {{ write: boolean, root?: string }} options
 * @returns {string[]} paths of the files that differed
 */
export function update(files, { write, root = repository }) {
	const stale = files.filter(({ path, text }) => {
		const file = join(root, path);
		return !existsSync(file) || readFileSync(file, "utf8") !== text;
	});
	if (write) for (const { path, text } of stale) replaceFile(join(root, path), text);
	return stale.map(({ path }) => path);
}

/**
 * Removes `folder` and the folders above it, below `top`, that are empty: the build takes every folder of models for a
 * model.
 */
function removeEmptyFolders(folder, top) {
	for (let at = folder; at !== top; at = dirname(at)) {
		try {
			rmdirSync(at);
		} catch {
			return; // Not empty, or removed by another process.
		}
	}
}

/** Removes generated code that no table makes, such as that of a model that was removed. */
function removeOrphans(files, { write, root }) {
	const made = new Set(files.map(({ path }) => join(root, path)));
	return codeFolders.flatMap((folder) => {
		const top = join(root, folder);
		if (!existsSync(top)) return [];
		const found = readdirSync(top, { recursive: true, encoding: "utf8" }).filter(isCode);
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
 * @param {{ write?: boolean, only?: "code" | "pages", root?: string }} [options] `only`: the other files are left as they are; `root`: the
 *   folder that is written to
 * @returns {string[]} paths of the files that were written or removed; without `write`, of those that would be
 */
export function generate({ write = true, only, root = repository } = {}) {
	const files = generatedFiles();
	const wanted = only ? files.filter(({ path }) => isCode(path) === (only === "code")) : files;
	const stale = update(wanted, { write, root });
	return only === "pages" ? stale : [...stale, ...removeOrphans(files, { write, root })];
}

/** Brings the code up to date: what a command does before it reads it. */
export const generateCode = () => generate({ only: "code" });
