/** Running the programs of a stage. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { run } from "../../wasm-core/tools/process.mjs";
import { buildFolder, repository } from "../../wasm-core/tools/repository.mjs";

/** A stage failed because of the code under test. The message is printed without a stack trace. */
export class StageError extends Error {}

/**
 * This process's environment without NODE_ENV. Vite sets it in a process that uses Vite (the stage "docs" does), and a
 * build that inherits it is one for development.
 *
 * @returns {NodeJS.ProcessEnv}
 */
export function inheritedEnvironment() {
	const { NODE_ENV, ...environment } = process.env;
	return environment;
}

/**
 * Runs a script of the repository or of node_modules, shows its output, and returns its status.
 *
 * @param {string} script from the repository's root
 * @param {string[]} args
 * @param {NodeJS.ProcessEnv} [env] variables added to the inherited environment
 * @returns {Promise<number>}
 */
export async function node(script, args, env = {}) {
	const options = { cwd: repository, env: { ...inheritedEnvironment(), ...env }, show: process.stdout };
	return (await run(process.execPath, [join(repository, script), ...args], options)).status;
}

/** Runs a script as `node` does. Throws a StageError where it fails. */
export async function mustSucceed(script, args = [], env = {}) {
	if ((await node(script, args, env)) !== 0) throw new StageError("see above");
}

/** The path of a report that a stage writes. */
export const reportPath = (name) => join(buildFolder, "reports", name);
export const readReport = (name) => JSON.parse(readFileSync(reportPath(name), "utf8"));
