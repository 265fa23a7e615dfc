/** Runs integrations/blender in Blender without a window (`bpy` from PyPI), with a running service. */

import { spawn } from "node:child_process";
import { join } from "node:path";
import { setTimeout } from "node:timers/promises";
import { run } from "../../wasm-core/tools/process.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { freePort } from "../free_port.mjs";
import { installed } from "../readers/programs.mjs";
import { checksIn } from "./checks.mjs";

/**
 * Runs the checks of blender.py with a game tree.
 * @param {import("./game_tree.mjs").TreeFiles} tree
 * @returns {Promise<import("./checks.mjs").Check[]>}
 */
export async function inBlender(tree) {
	const python = await installed("readers", "python3.11");
	const port = await freePort();
	const service = spawn(process.execPath, ["wasm-core/tools/service.mjs", "--port", String(port)], { cwd: repository });
	try {
		const address = `http://127.0.0.1:${port}`;
		await answering(`${address}/specimens/`);
		const script = join(repository, "tests/integrations/blender.py");
		const words = [script, repository, tree.glb, String(tree.expected.height), address];
		const { status, output } = await run(python, words, { cwd: repository });
		return [...checksIn(output), { title: "all checks run", passed: status === 0, found: output.slice(-1500) }];
	} finally {
		service.kill("SIGTERM");
	}
}

/** Waits until a service answers, for at most two minutes. */
async function answering(address) {
	for (let tries = 0; tries < 240; tries++) {
		if (
			await fetch(address).then(
				(response) => response.ok,
				() => false,
			)
		)
			return;
		await setTimeout(500);
	}
	throw new Error(`The service at ${address} does not answer.`);
}
