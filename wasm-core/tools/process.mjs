/** Runs other programs. */
import { spawn, spawnSync } from "node:child_process";

/** Standard output of a program that ends at once; null when it fails. */
export function capture(command, args, env = process.env) {
	const { status, stdout } = spawnSync(command, args, { encoding: "utf8", env, stdio: ["ignore", "pipe", "ignore"] });
	return status === 0 ? stdout : null;
}

/**
 * Runs a program to its end. Its output is collected, and passed on to `show` at once.
 *
 * @param {string} command
 * @param {string[]} args
 * @param {{ cwd?: string, env?: NodeJS.ProcessEnv, show?: NodeJS.WritableStream }} [options]
 * @returns {Promise<{ status: number, output: string }>} status 127 when it could not be started
 */
export function run(command, args, { cwd, env = process.env, show } = {}) {
	return new Promise((resolve) => {
		const child = spawn(command, args, { cwd, env, stdio: ["ignore", "pipe", "pipe"] });
		/** @type {Buffer[]} */
		const pieces = [];
		const collect = (piece) => {
			pieces.push(piece);
			show?.write(piece);
		};
		child.stdout.on("data", collect);
		child.stderr.on("data", collect);
		child.on("error", (error) => resolve({ status: 127, output: error.message }));
		child.on("close", (status) => resolve({ status: status ?? 1, output: Buffer.concat(pieces).toString("utf8") }));
	});
}
