/** Builds and runs suites in a copy. */
import { spawn } from "node:child_process";
import { join } from "node:path";
import { transformWithOxc } from "vite";
import { freePort } from "../free_port.mjs";
import { programOf, suiteOf } from "./mutants.mjs";

/** Milliseconds after which a suite counts as one that does not end. */
const PATIENCE = { core: 300_000, web: 600_000, e2e: 400_000 };
/** Configurations of Vite and of vitest in a copy. */
const VITE = ["--config", "tests/mutants/vite.config.ts"];
const VITEST = ["--config", "tests/mutants/vitest.config.ts"];

/**
 * Runs a program and its child processes at the extent of the long run, because some tests that catch a mutant are not
 * in the gate. `late` reports that it was ended because it took too long.
 */
function run(folder, command, args, { timeout = 600_000, env = {} } = {}) {
	return new Promise((resolve) => {
		const child = spawn(command, args, {
			cwd: folder,
			env: { ...process.env, NO_COLOR: "1", PANICLE_LONG: "1", ...env },
			stdio: ["ignore", "pipe", "pipe"],
			detached: true,
		});
		let output = "";
		let late = false;
		const timer = setTimeout(() => {
			late = true;
			process.kill(-child.pid, "SIGKILL");
		}, timeout);
		for (const stream of [child.stdout, child.stderr]) stream.on("data", (piece) => (output += piece));
		child.on("error", (error) => resolve({ status: 127, output: error.message, late }));
		child.on("close", (status) => {
			clearTimeout(timer);
			resolve({ status: status ?? 1, output, late });
		});
	});
}

const node = (folder, script, args, options) => run(folder, process.execPath, [script, ...args], options);

/** A mutant that does not parse is an error of the list. Shaders and types are not checked. */
export async function syntaxError(file, text) {
	if (!/\.(ts|mjs)$/.test(file)) return undefined;
	try {
		await transformWithOxc(text, file);
		return undefined;
	} catch (error) {
		return error.message;
	}
}

/** Suites of one kind that need the same thing built. */
const BUILDS = {
	core: (folder, suites) =>
		node(folder, "wasm-core/tools/core.mjs", ["native", ...new Set(suites.map(({ path }) => programOf(path)))]),
	web: async () => ({ status: 0, output: "", late: false }),
	e2e: (folder) => node(folder, "node_modules/vite/bin/vite.js", ["build", ...VITE]),
};

const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");

const RUNS = {
	core: async (folder, suites, timeout) => {
		const programs = [...new Set(suites.map(({ path }) => programOf(path)))];
		for (const program of programs) {
			const files = suites.filter(({ path }) => programOf(path) === program).map(({ path }) => `*/${path}`);
			const args = ["--no-colors", "--abort-after=1", `--source-file=${files.join(",")}`];
			const ended = await run(folder, join(folder, "build/native", program), args, { timeout });
			if (ended.status !== 0) return ended;
			if (/test cases: +0 /.test(ended.output)) throw new Error(`${files} holds no test of ${program}.`);
		}
		return { status: 0, output: "", late: false };
	},
	web: (folder, suites, timeout) =>
		node(folder, "node_modules/vitest/vitest.mjs", ["run", ...VITEST, ...suites.map(({ path }) => path)], {
			timeout,
		}),
	e2e: async (folder, suites, timeout) => {
		const titles = suites.map(({ title }) => title).filter(Boolean);
		const grep = titles.length === suites.length ? ["--grep", titles.map(escaped).join("|")] : [];
		const args = ["test", ...new Set(suites.map(({ path }) => path)), ...grep, "--max-failures=1"];
		const env = { PANICLE_PORT: String(await freePort()), PANICLE_E2E_REPORT: "" };
		const ended = await node(folder, "node_modules/@playwright/test/cli.js", args, { timeout, env });
		if (/No tests found/.test(ended.output))
			throw new Error(`No test of ${suites.map(({ path }) => path)} has that title.`);
		return ended;
	},
};

/**
 * Builds the files that suites of one kind need and runs them.
 * @param {string} folder the copy
 * @param {string[]} texts
 * @param {{ patient?: boolean }} [options] patient: as long as it takes
 * @returns {Promise<{ outcome: "passed" | "failed" | "unbuilt" | "slow", output: string }>}
 */
export async function runSuites(folder, texts, { patient = false } = {}) {
	const suites = texts.map(suiteOf);
	const { kind } = suites[0];
	const built = await BUILDS[kind](folder, suites);
	if (built.status !== 0) return { outcome: "unbuilt", output: built.output };
	const { status, output, late } = await RUNS[kind](folder, suites, patient ? 3_600_000 : PATIENCE[kind]);
	return { outcome: late ? "slow" : status === 0 ? "passed" : "failed", output };
}
