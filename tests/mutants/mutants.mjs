/**
 * The list of mutants: plausible one-line faults, each with the suites that should detect it, and checks that run
 * nothing.
 */
import { createHash } from "node:crypto";

/**
 * @typedef {object} Fault
 * @property {string} id unique in the whole list
 * @property {string} find text that stands in the file exactly once
 * @property {string} replace the text in its place
 * @property {string} breaks one line: the effect that a user would see
 * @property {string[]} [suites] in place of the group's
 * @property {string} [survives] why nothing notices, where that is known
 * @property {boolean} [hangs] whether a suite that does not end counts as one that noticed
 *
 * @typedef {object} Group faults of one file
 * @property {string} file from the repository's root
 * @property {string[]} suites narrowest first: a test's file, or a folder of web tests with a slash at its end; of an
 *   end-to-end test `file: words of its title`
 * @property {Fault[]} faults
 *
 * @typedef {Fault & { file: string, suites: string[], kind: Kind }} Mutant
 * @typedef {"core" | "web" | "e2e"} Kind
 *
 * @typedef {object} Suite
 * @property {Kind} kind
 * @property {string} path
 * @property {string} [title]
 */

/** In the order in which they are run. @type {Kind[]} */
export const KINDS = ["core", "web", "e2e"];

/** @param {string} text @returns {Suite} */
export function suiteOf(text) {
	if (text.endsWith("_test.cpp")) return { kind: "core", path: text };
	const [path, title] = text.split(/: (.*)/s);
	return path.endsWith(".spec.ts") ? { kind: "e2e", path, title } : { kind: "web", path: text };
}

/** The native program that holds a test's file. @param {string} path */
export function programOf(path) {
	const [, room] = /^tests\/core\/(?:models\/)?([^/]+)\//.exec(path) ?? [];
	return `${room}_tests`;
}

/** @param {Group[]} groups @returns {Mutant[]} by kind, those of one file together */
export function mutantsOf(groups) {
	const all = groups.flatMap(({ file, suites, faults }) =>
		faults.map((fault) => {
			const own = fault.suites ?? suites;
			return { ...fault, file, suites: own, kind: suiteOf(own[0]).kind };
		}),
	);
	return KINDS.flatMap((kind) => all.filter((mutant) => mutant.kind === kind));
}

const countOf = (text, part) => text.split(part).length - 1;

/** The file's text with the fault in it; undefined where its place is not to be found, or not the only one. */
export function applied(text, { find, replace }) {
	return countOf(text, find) === 1 ? text.replace(find, () => replace) : undefined;
}

/**
 * Problems of a mutant in the list.
 *
 * @param {Mutant} mutant
 * @param {(path: string) => string | undefined} read the text of a file; of a folder "", undefined where there is none
 * @returns {string[]}
 */
export function problemsOf(mutant, read) {
	const text = read(mutant.file);
	const problems = [];
	if (mutant.file.includes(".generated.")) problems.push(`${mutant.file} is generated: mutate the table or its maker`);
	if (text === undefined) problems.push(`${mutant.file} is not there`);
	else if (countOf(text, mutant.find) !== 1) {
		problems.push(`“${mutant.find}” stands ${countOf(text, mutant.find)} times in ${mutant.file}, not once`);
	}
	if (mutant.find === mutant.replace) problems.push("it changes nothing");
	for (const suite of mutant.suites) {
		const { path, title } = suiteOf(suite);
		const tests = read(path);
		if (tests === undefined) problems.push(`its suite ${path} is not there`);
		else if (title && !tests.includes(title)) problems.push(`${path} has no test “${title}”`);
	}
	return problems.map((problem) => `${mutant.id}: ${problem}`);
}

/** Ids that several mutants have. @param {Mutant[]} mutants */
export function repeatedIds(mutants) {
	const ids = mutants.map(({ id }) => id);
	return [...new Set(ids.filter((id, i) => ids.indexOf(id) !== i))];
}

/**
 * Key of a result, which is valid as long as the fault, its file and its suites are unchanged.
 *
 * @param {Mutant} mutant
 * @param {(path: string) => string | undefined} read as above; of a folder, its files' texts
 */
export function keyOf({ file, find, replace, suites, hangs }, read) {
	const tests = suites.map((suite) => read(suiteOf(suite).path) ?? "");
	const parts = [file, find, replace, suites, hangs ?? false, read(file) ?? "", tests];
	return createHash("sha256").update(JSON.stringify(parts)).digest("hex").slice(0, 16);
}

/** Those in whose id or file one of the words stands, a kind's word meaning the kind; all without a word. */
export function selected(mutants, words) {
	if (words.length === 0) return mutants;
	const means = ({ id, file, kind }, word) => (KINDS.includes(word) ? kind === word : `${id} ${file}`.includes(word));
	return mutants.filter((mutant) => words.some((word) => means(mutant, word)));
}

/**
 * The part of a list for one of several programs: an equal share of every kind, mutants of a file together.
 *
 * @param {Mutant[]} mutants
 * @param {number} part from 1
 * @param {number} parts
 */
export function sharded(mutants, part, parts) {
	return KINDS.flatMap((kind) => {
		const some = mutants.filter((mutant) => mutant.kind === kind);
		const from = Math.round(((part - 1) * some.length) / parts);
		return some.slice(from, Math.round((part * some.length) / parts));
	});
}

/**
 * @param {string[]} args of `npm run mutants --`
 * @returns {{ words: string[], part: number, parts: number, again: boolean, report: boolean } | { wrong: string }}
 */
export function parseArguments(args) {
	const wishes = { words: [], part: 1, parts: 1, again: false, report: false };
	for (let i = 0; i < args.length; i++) {
		const arg = args[i];
		if (arg === "--again") wishes.again = true;
		else if (arg === "--report") wishes.report = true;
		else if (arg === "--shard") {
			const [, part, parts] = /^([1-9]\d*)\/([1-9]\d*)$/.exec(args[++i] ?? "") ?? [];
			if (!part || Number(part) > Number(parts)) return { wrong: "--shard takes a part of how many, like 1/4" };
			Object.assign(wishes, { part: Number(part), parts: Number(parts) });
		} else if (arg.startsWith("-")) return { wrong: `there is no ${arg}; there are --again, --report, --shard 1/4` };
		else wishes.words.push(arg);
	}
	return wishes;
}
