/**
 * `npm test`: every stage in turn, each timed, stopping at the first that fails. The last line says how many tests
 * passed and failed in all. `npm test -- types bunch` runs the set-up and what is named alone: a stage, or the tests of a
 * room or of a model (tests/selection.mjs). Runs on a clean clone: nothing here may import a package.
 */
import { mkdirSync, readFileSync, rmSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join } from "node:path";
import { buildCore, CoreBuildError } from "../wasm-core/tools/core.mjs";
import { generate } from "../wasm-core/tools/generate.mjs";
import { run } from "../wasm-core/tools/process.mjs";
import { buildFolder, repository } from "../wasm-core/tools/repository.mjs";
import { setUp } from "../wasm-core/tools/setup.mjs";
import { ToolchainError } from "../wasm-core/tools/toolchain.mjs";
import { prepareBrowsers } from "./browsers/browsers.mjs";
import { freePort } from "./free_port.mjs";
import { rooms, select } from "./selection.mjs";

const reports = join(buildFolder, "reports");
const show = process.stdout;
// The programs below write to a pipe, and some would colour even that.
if (!show.isTTY) process.env.NO_COLOR = "1";

/** A stage that says what is wrong with the code, as opposed to one that went wrong itself. */
class StageError extends Error {}

/** Runs a program of node_modules, or a script of ours, and fails with what it says. */
async function node(script, args, env = process.env) {
	const { status } = await run(process.execPath, [join(repository, script), ...args], { cwd: repository, env, show });
	return status;
}

async function mustSucceed(script, args) {
	if ((await node(script, args)) !== 0) throw new StageError("see above");
}

async function types() {
	for (const project of [".", "wasm-core/tools"]) {
		await mustSucceed("node_modules/typescript/bin/tsc", ["--noEmit", "--project", project]);
	}
}

const readReport = (name) => JSON.parse(readFileSync(join(reports, name), "utf8"));

function generatedFiles() {
	const stale = generate({ write: false });
	if (stale.length > 0) throw new StageError(`stale: ${stale.join(", ")}; run \`npm run generate\``);
}

/** The core's own tests, natively, under the address and undefined-behaviour sanitizers. */
async function nativeTests() {
	const programs = selection.native ?? ["core_tests"];
	await buildCore("asan", programs);
	const total = { passed: 0, failed: 0 };
	for (const program of programs) {
		for (const { passed, failed } of await nativeRuns(join(buildFolder, "asan", program))) {
			total.passed += passed;
			total.failed += failed;
		}
	}
	return total;
}

/** Runs of cases that a program of tests is divided into, as many at a time as there are processors. */
const NATIVE_RUNS = 12;

/** Every case of a program, in runs side by side; what failed is shown. */
async function nativeRuns(program) {
	const { output } = await run(program, ["--no-colors", "--count"]);
	const cases = Number(/filters: (\d+)/.exec(output)?.[1]);
	if (!(cases > 0)) throw new StageError(`${program} has no tests`);
	const firsts = Array.from({ length: NATIVE_RUNS }, (_, i) => Math.floor((i * cases) / NATIVE_RUNS) + 1);
	const waiting = firsts.map((first, i) => ({ first, last: (firsts[i + 1] ?? cases + 1) - 1 }));
	const results = [];
	const work = async () => {
		for (let range = waiting.shift(); range; range = waiting.shift()) results.push(await nativeRun(program, range));
	};
	await Promise.all(Array.from({ length: availableParallelism() }, work));
	return results;
}

async function nativeRun(program, { first, last }) {
	if (last < first) return { passed: 0, failed: 0 };
	const { status, output } = await run(program, ["--no-colors", `--first=${first}`, `--last=${last}`]);
	const counts = /test cases: +\d+ \| +\d+ passed \| +(\d+) failed/.exec(output);
	if (status !== 0) console.log(output);
	if (!counts)
		throw new StageError(`${program}, cases ${first} to ${last}: ended with status ${status} before its summary`);
	// The summary counts the cases outside of the range as passed.
	const failed = Math.max(Number(counts[1]), status === 0 ? 0 : 1);
	return { passed: last - first + 1 - failed, failed };
}

/** What vitest runs, and counts in a report of that name. */
async function vitest(report, args) {
	const outputs = ["--reporter=default", "--reporter=json", `--outputFile=${join(reports, report)}`];
	const status = await node("node_modules/vitest/vitest.mjs", ["run", ...args, ...outputs]);
	const { numPassedTests, numFailedTests } = readReport(report);
	return { passed: numPassedTests, failed: Math.max(numFailedTests, status === 0 ? 0 : 1) };
}

async function endToEndTests() {
	const env = { ...process.env, PANICLE_PORT: String(await freePort()), PANICLE_E2E_REPORT: join(reports, "e2e.json") };
	const status = await node("node_modules/@playwright/test/cli.js", ["test"], env);
	const { stats } = readReport("e2e.json");
	return { passed: stats.expected + stats.flaky, failed: Math.max(stats.unexpected, status === 0 ? 0 : 1) };
}

/** The built app in browsers besides Chromium; those that cannot be had on this machine are named. */
async function otherBrowsers() {
	const { there, without } = await prepareBrowsers();
	for (const line of without) console.log(line);
	if (there.length === 0) return { passed: 0, failed: 0 };
	const files = there.map((name) => `tests/browsers/${name}.test.ts`);
	return vitest("browsers.json", ["--config", "tests/browsers/vitest.config.ts", ...files]);
}

const all = [
	["set-up", () => setUp("test")],
	["generated", generatedFiles],
	["layout", () => mustSucceed("wasm-core/tools/format.mjs", ["--check"])],
	["types", types],
	["native core", nativeTests],
	["wasm core", () => buildCore("wasm", ["all", "toy"])],
	["web", () => vitest("vitest.json", selection.web)],
	["app", () => mustSucceed("node_modules/vite/bin/vite.js", ["build"])],
	["e2e", endToEndTests],
	["browsers", otherBrowsers],
];
const names = all.map(([stage]) => stage);
const selection = select(process.argv.slice(2), names);
if ("unknown" in selection) {
	console.error(
		`No stage, room or model “${selection.unknown.join("”, “")}”; there are: ${[...names, ...rooms()].join(", ")}.`,
	);
	process.exit(2);
}
const stages = all.filter(([stage], i) => i === 0 || selection.stages.includes(stage));

/** Runs one stage and says how it went. */
async function runStage([name, work]) {
	const from = performance.now();
	console.log(`\n── ${name}`);
	const result = { name, passed: 0, failed: 0, problem: "" };
	try {
		const { passed = 0, failed = 0 } = (await work()) ?? {};
		Object.assign(result, { passed, failed, problem: failed > 0 ? "see above" : "" });
	} catch (error) {
		const known = [StageError, ToolchainError, CoreBuildError].some((kind) => error instanceof kind);
		Object.assign(result, { failed: 1, problem: known ? error.message : error.stack });
	}
	return { ...result, seconds: (performance.now() - from) / 1000 };
}

function table(results) {
	const rows = stages.map(([name]) => {
		const result = results.find((r) => r.name === name);
		if (!result) return `  ${name.padEnd(12)} not run`;
		const tests = result.passed + result.failed > 0 ? `${result.passed} passed, ${result.failed} failed` : "";
		return `  ${name.padEnd(12)} ${result.seconds.toFixed(1).padStart(6)} s  ${tests || "ok"}`;
	});
	return rows.join("\n");
}

rmSync(reports, { recursive: true, force: true });
mkdirSync(reports, { recursive: true });
const results = [];
for (const stage of stages) {
	const result = await runStage(stage);
	results.push(result);
	if (result.failed === 0) continue;
	console.log(`\nStage “${result.name}” failed: ${result.problem}`);
	process.exitCode = 1;
	break;
}
const total = (key) => results.reduce((sum, result) => sum + result[key], 0);
console.log(`\n${table(results)}\n`);
console.log(`${total("passed")} passed, ${total("failed")} failed`);
