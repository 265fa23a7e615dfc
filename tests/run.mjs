/**
 * Runs the tests: every stage in turn, stopping at the first that fails. At the end it prints a table of stages with
 * the slowest tests, writes it to build/test-times.json, and counts the tests in the last line.
 *
 *     npm test                  the gate: must pass before a change lands
 *     npm run test:long         everything, in full (CONTRIBUTING.md)
 *     npm run test:changed      the tests of changes since this branch left main
 *     npm test -- types bunch   the set-up, and the stages, rooms or models named
 *
 * Works on a clean clone: nothing here may import a package.
 */
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { CoreBuildError } from "../wasm-core/tools/core.mjs";
import { buildFolder } from "../wasm-core/tools/repository.mjs";
import { ToolchainError } from "../wasm-core/tools/toolchain.mjs";
import { readArguments } from "./runner/arguments.mjs";
import { StageError } from "./runner/process.mjs";
import { stages } from "./runner/stages.mjs";
import { slowest, table } from "./runner/times.mjs";

/** Runs one stage and returns how it went. */
async function runStage({ name, run }, plan) {
	const from = performance.now();
	console.log(`\n── ${name}`);
	const result = { name, passed: 0, failed: 0, problem: "", tests: [] };
	try {
		Object.assign(result, await run(plan));
		if (result.failed > 0) result.problem = "see above";
	} catch (error) {
		const isKnown = [StageError, ToolchainError, CoreBuildError].some((kind) => error instanceof kind);
		Object.assign(result, { failed: 1, problem: isKnown ? error.message : error.stack });
	}
	return { ...result, seconds: (performance.now() - from) / 1000 };
}

const plan = readArguments(process.argv.slice(2), stages);
if ("nothing" in plan) {
	console.log(plan.nothing);
	process.exit(0);
}
if ("problem" in plan) {
	console.error(plan.problem);
	process.exit(2);
}
if (plan.isLong) {
	// Read by tests in every language (tests/long_run.mjs, tests/core/fuzz_dice.hpp).
	process.env.PANICLE_LONG = "1";
	process.env.PANICLE_FUZZ ??= "20000";
	process.env.PANICLE_SEED ??= String(Math.floor(Math.random() * 2 ** 31));
	console.log(`Random tests use PANICLE_SEED=${process.env.PANICLE_SEED}.`);
}
// The programs below write to a pipe, and some would colour even that.
if (!process.stdout.isTTY) process.env.NO_COLOR = "1";
const reports = join(buildFolder, "reports");
rmSync(reports, { recursive: true, force: true });
mkdirSync(reports, { recursive: true });

const chosen = stages.filter(({ name }) => plan.stages.includes(name));
const results = [];
for (const stage of chosen) {
	const result = await runStage(stage, plan);
	results.push(result);
	if (result.failed === 0) continue;
	console.log(`\nStage “${result.name}” failed: ${result.problem}`);
	process.exitCode = 1;
	break;
}

const total = (key) => results.reduce((sum, result) => sum + result[key], 0);
const times = {
	run: process.argv.length > 2 && !plan.isLong ? "part" : plan.isLong ? "long" : "gate",
	seconds: total("seconds"),
	stages: results.map(({ name, seconds, passed, failed }) => ({ name, seconds, passed, failed })),
	slowest: slowest(results, 10),
};
writeFileSync(join(buildFolder, "test-times.json"), `${JSON.stringify(times, null, "\t")}\n`);
console.log(`\n${table(chosen, results, times.slowest)}\n`);
console.log(`${total("passed")} passed, ${total("failed")} failed`);
