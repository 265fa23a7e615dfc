/** Running other programs. */
import { spawn, spawnSync } from "node:child_process";

/** Standard output of a program that ends at once; null when it fails. */
export function capture(command, args, env = process.env) {
	const { status, stdout } = spawnSync(command, args, { encoding: "utf8", env, stdio: ["ignore", "pipe", "ignore"] });
	return status === 0 ? stdout : null;
}

/**
 * Runs a program to its end. All it says is collected, and with `show` also goes to standard error as it comes:
 * standard output belongs to those who call us for an answer.
 *
 * @param {string} command
 * @param {string[]} args
 * @param {{ cwd?: string, env?: NodeJS.ProcessEnv, show?: boolean }} [options]
 * @returns {Promise<{ status: number, output: string }>} status 127 when it could not be started
 */
export function run(command, args, { cwd, env = process.env, show = false } = {}) {
	return new Promise((resolve) => {
		const child = spawn(command, args, { cwd, env, stdio: ["ignore", "pipe", "pipe"] });
		const pieces = [];
		const hear = (piece) => {
			pieces.push(piece);
			if (show) process.stderr.write(piece);
		};
		child.stdout.on("data", hear);
		child.stderr.on("data", hear);
		child.on("error", (error) => resolve({ status: 127, output: error.message }));
		child.on("close", (status) => resolve({ status: status ?? 1, output: Buffer.concat(pieces).toString("utf8") }));
	});
}
