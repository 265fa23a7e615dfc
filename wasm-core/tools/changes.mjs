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
 * The commit from which changes are counted: where this branch left `main`; on `main` itself, the last release. `PANICLE_BASE`
 * names another; in a pull request on GitHub its target branch takes the place of `main`.
 *
 * @param {Options} [options]
 * @returns {string | undefined} undefined where there is no git or no history
 */
export function changeBase({ folder = repository, env = process.env } = {}) {
	const git = gitIn(folder);
	const named = env.PANICLE_BASE || (env.GITHUB_BASE_REF && `origin/${env.GITHUB_BASE_REF}`);
	const head = git("rev-parse", "HEAD");
	for (const branch of named ? [named] : ["origin/main", "main"]) {
		const base = git("merge-base", "HEAD", branch);
		if (base && base !== head) return base;
	}
	return git("log", "-1", "--format=%H", "--", RELEASE) || git("rev-parse", "--verify", "--quiet", "HEAD^1");
}

/**
 * Files that were changed since `changeBase()`: committed, uncommitted, new and deleted ones. Paths from the root of the
 * repository.
 *
 * @param {Options} [options]
 * @returns {string[] | undefined} undefined where they cannot be known
 */
export function changedFiles({ folder = repository, env = process.env } = {}) {
	const git = gitIn(folder);
	const base = changeBase({ folder, env });
	const changed = base && git("diff", "--name-only", base);
	const untracked = git("ls-files", "--others", "--exclude-standard");
	if (typeof changed !== "string" || untracked === undefined) return undefined;
	return [...new Set([...changed.split("\n"), ...untracked.split("\n")])].filter(Boolean).sort();
}
