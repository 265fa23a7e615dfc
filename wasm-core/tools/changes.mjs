/** Lists the files that the current branch changes. */
import { capture } from "./process.mjs";
import { repository } from "./repository.mjs";

/** @typedef {{ folder?: string, env?: NodeJS.ProcessEnv }} Options folder: of the repository */

/** @param {string} folder */
const gitIn =
	(folder) =>
	(...words) =>
		capture("git", ["-C", folder, ...words])?.trim();

/** The file that each release writes anew: the last commit that changed it is the last release. */
const RELEASE = "tests/sizes/last_release.json";

/**
 * The commit from which changes are counted: where this branch left `main`, or HEAD on `main` itself, where only uncommitted
 * changes count. `PANICLE_BASE` names another; in a pull request on GitHub its target branch takes the place of `main`.
 *
 * @param {Options} [options]
 * @returns {string | undefined} undefined where there is no git or no history
 */
export function changeBase({ folder = repository, env = process.env } = {}) {
	const git = gitIn(folder);
	const named = env.PANICLE_BASE || (env.GITHUB_BASE_REF && `origin/${env.GITHUB_BASE_REF}`);
	const head = git("rev-parse", "HEAD");
	const bases = (named ? [named] : ["origin/main", "main"]).map((branch) => git("merge-base", "HEAD", branch));
	return bases.find((base) => base && base !== head) ?? head;
}

/**
 * The commit from which the gate counts changes: as `changeBase`, but on `main` itself the last release.
 *
 * @param {Options} [options]
 * @returns {string | undefined} undefined where there is no git, or no release in its history
 */
export function gateBase({ folder = repository, env = process.env } = {}) {
	const git = gitIn(folder);
	const base = changeBase({ folder, env });
	return base !== git("rev-parse", "HEAD") ? base : git("log", "-1", "--format=%H", "--", RELEASE) || undefined;
}

/**
 * Files that were changed since a commit: committed, uncommitted, new and deleted ones. Paths from the root of the repository.
 *
 * @param {Options & { base?: string | undefined }} [options] base: by default `changeBase()`
 * @returns {string[] | undefined} undefined where they cannot be known
 */
export function changedFiles(options = {}) {
	const { folder = repository, base = changeBase(options) } = options;
	const git = gitIn(folder);
	const changed = base && git("diff", "--name-only", base);
	const untracked = git("ls-files", "--others", "--exclude-standard");
	if (typeof changed !== "string" || untracked === undefined) return undefined;
	return [...new Set([...changed.split("\n"), ...untracked.split("\n")])].filter(Boolean).sort();
}
