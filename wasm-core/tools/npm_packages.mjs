/** Checks whether node_modules agrees with package-lock.json, and installs the packages if not. Needs only Node. */
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { run } from "./process.mjs";
import { repository } from "./repository.mjs";
import { ToolchainError } from "./toolchain.mjs";

const readJson = (path) => (existsSync(path) ? JSON.parse(readFileSync(path, "utf8")) : null);

/**
 * Whether an installation is the one that a lockfile describes: `installed` is npm's own record of it. Packages for
 * other systems are optional and may be absent.
 */
export function isInstalled(lock, installed) {
	if (!installed) return false;
	const wanted = Object.entries(lock.packages).filter(([path]) => path !== "");
	const same = ([path, { version, integrity }]) => {
		const there = installed.packages[path];
		return there?.version === version && there?.integrity === integrity;
	};
	const known = Object.keys(installed.packages).every((path) => path in lock.packages);
	return known && wanted.every((entry) => same(entry) || (entry[1].optional && !(entry[0] in installed.packages)));
}

/** Returns npm's error message without its page of help. */
function reason(output) {
	const errors = output.split("\n").filter((line) => /^npm error \S/.test(line));
	const help = errors.findIndex((line) => /^npm error (Usage|Clean install|A complete log)/.test(line));
	return errors.slice(0, help < 0 ? undefined : help).join("\n") || output.trim();
}

/** Runs npm: the same one that has started this program, if any. */
export function npm(words, cwd) {
	const own = process.env.npm_execpath;
	const [command, args] = own?.endsWith("js") ? [process.execPath, [own]] : ["npm", []];
	return run(command, [...args, ...words], { cwd });
}

/** Runs `npm ci` where the packages are missing or stale. */
export async function ensurePackages({ log = console.error } = {}) {
	const lock = readJson(join(repository, "package-lock.json"));
	const installed = readJson(join(repository, "node_modules/.package-lock.json"));
	if (isInstalled(lock, installed)) return;
	log("Installing npm packages …");
	const { status, output } = await npm(["ci", "--no-audit", "--no-fund"], repository);
	if (status !== 0) throw new ToolchainError(`npm ci failed:\n${reason(output)}`);
}
