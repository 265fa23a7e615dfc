/** Running the programs of a stage. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { run } from "../../wasm-core/tools/process.mjs";
import { buildFolder, repository } from "../../wasm-core/tools/repository.mjs";

/** A stage failed because of the code under test. The message is printed without a stack trace. */
export class StageError extends Error {}

/**
 * Runs a script of the repository or of node_modules, shows its output, and returns its status.
 *
 * @param {string} script from the repository's root
 * @param {string[]} args
 * @param {NodeJS.ProcessEnv} [env]
 * @returns {Promise<number>}
 */
export async function node(script, args, env = process.env) {
	const options = { cwd: repository, env, show: process.stdout };
	return (await run(process.execPath, [join(repository, script), ...args], options)).status;
}

/** Runs a script as `node` does. Throws a StageError where it fails. */
export async function mustSucceed(script, args = [], env = {}) {
	if ((await node(script, args, { ...process.env, ...env })) !== 0) throw new StageError("see above");
}

/** The path of a report that a stage writes. */
export const reportPath = (name) => join(buildFolder, "reports", name);
export const readReport = (name) => JSON.parse(readFileSync(reportPath(name), "utf8"));
