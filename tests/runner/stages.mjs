/**
 * The stages of a test run, in order. Each returns how many tests passed and failed, and how long each took, or nothing
 * where it holds no tests. It throws a StageError, or an error of the toolchain, where it fails as a whole.
 */
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { generate, update } from "../../wasm-core/tools/generate/files.mjs";
import { setUp } from "../../wasm-core/tools/setup.mjs";
import { prepareBrowsers } from "../browsers/browsers.mjs";
import { freePort } from "../free_port.mjs";
import { changedRooms } from "./changed.mjs";
import { nativeTests } from "./native.mjs";
import { mustSucceed, node, readReport, reportPath, StageError } from "./process.mjs";

/** @typedef {import("./arguments.mjs").Plan} Plan */

/** Fails where a generated page of the documentation is out of date, or a count in one. */
async function stalePages() {
	const stale = generate({ write: false, only: "pages" });
	if (stale.length > 0) throw new StageError(`stale: ${stale.join(", ")}; run \`npm run docs -- tables\``);
	await staleFigures({ sizes: false });
}

/** Fails where a number in a page of the documentation is out of date. */
async function staleFigures(options) {
	const { pagesWithFigures } = await import("../sizes/figures.mjs");
	const stale = update(await pagesWithFigures(options), { write: false });
	if (stale.length > 0) throw new StageError(`stale: ${stale.join(", ")}; run \`npm run docs -- figures\``);
}

/** Checks the types of the page with the tests, and of the tools. */
async function types() {
	for (const project of [".", "wasm-core/tools"]) {
		await mustSucceed("node_modules/typescript/bin/tsc", ["--noEmit", "--project", project]);
	}
}

/**
 * The native tests, with sanitizers in the rooms that changed and in the boundary, where all data enters.
 *
 * @param {Plan} plan
 */
function native({ native: programs, isLong }) {
	return nativeTests("native", programs, isLong ? [] : [...new Set(["boundary", ...changedRooms()])].sort());
}

/** For programs that need the modules, which the stage `wasm` has built. */
const BUILT = { PANICLE_CORE: "built" };

/** Runs vitest; `report` names its report. */
async function vitest(report, args) {
	const outputs = ["--reporter=default", "--reporter=json", `--outputFile=${reportPath(report)}`];
	const status = await node("node_modules/vitest/vitest.mjs", ["run", ...args, ...outputs], BUILT);
	const { numPassedTests, numFailedTests, testResults } = readReport(report);
	const tests = testResults
		.flatMap(({ assertionResults }) => assertionResults)
		.filter(({ duration }) => duration > 0)
		.map(({ fullName, duration }) => ({ name: fullName, seconds: duration / 1000 }));
	return { passed: numPassedTests, failed: Math.max(numFailedTests, status === 0 ? 0 : 1), tests };
}

/** Every test of a Playwright report, with its path of titles and its time. */
function timedTests(suite, titles = []) {
	const own = (suite.specs ?? []).flatMap(({ title, tests }) =>
		tests.map(({ results }) => ({
			name: [...titles, title].join(" › "),
			seconds: results.reduce((sum, { duration }) => sum + duration, 0) / 1000,
		})),
	);
	const inner = (suite.suites ?? []).flatMap((each) => timedTests(each, [...titles, each.title]));
	return [...own, ...inner];
}

/** @param {Plan} plan */
async function endToEnd({ endToEnd: files }) {
	const env = {
		...BUILT,
		PANICLE_PORT: String(await freePort()),
		PANICLE_E2E_REPORT: reportPath("e2e.json"),
	};
	const status = await node("node_modules/@playwright/test/cli.js", ["test", ...files], env);
	const report = readReport("e2e.json");
	const { expected, unexpected, flaky } = report.stats;
	const failed = unexpected + flaky;
	return { passed: expected, failed: Math.max(failed, status === 0 ? 0 : 1), tests: timedTests(report) };
}

/** The built app in browsers besides Chromium; prints those that this machine cannot have. */
async function otherBrowsers() {
	const { there, without } = await prepareBrowsers();
	for (const line of without) console.log(line);
	if (there.length === 0) return undefined;
	const files = there.map((name) => `tests/browsers/${name}.test.ts`);
	return vitest("browsers.json", ["--config", "tests/browsers/vitest.config.ts", ...files]);
}

/** Sizes in bytes of built files, against those of the last release and those that the documentation states. */
async function sizes() {
	const { checkSizes } = await import("../sizes/check.mjs");
	const { table, advice } = checkSizes();
	console.log(table);
	if (advice) throw new StageError(advice);
	await staleFigures({});
}

/** Long use: of the model service by many requests, and of the page by random actions. */
async function longUse() {
	const service = await (await import("../bench/soak.mjs")).soak();
	const page = await (await import("../random_use/random_use.mjs")).randomUse();
	return { passed: service.passed + page.passed, failed: service.failed + page.failed };
}

/**
 * @type {{ name: string, isLong?: boolean, run: (plan: Plan) => unknown }[]}
 * `isLong`: part of the long run alone.
 */
export const stages = [
	{ name: "set-up", run: () => setUp("test").then(() => undefined) },
	{ name: "docs", run: stalePages },
	{ name: "lint", run: () => mustSucceed("wasm-core/tools/lint.mjs", ["--gate"]) },
	{ name: "types", run: types },
	{ name: "native", run: native },
	{ name: "wasm", run: () => buildCore("wasm", ["models", "toy"]).then(() => undefined) },
	{ name: "web", run: ({ web }) => vitest("vitest.json", web) },
	{ name: "app", run: () => mustSucceed("node_modules/vite/bin/vite.js", ["build"], BUILT) },
	{ name: "e2e", run: endToEnd },
	{ name: "sizes", run: sizes },
	{ name: "browsers", run: otherBrowsers },
	{ name: "sanitizers", isLong: true, run: () => nativeTests("asan", ["core_tests"]) },
	{ name: "readers", isLong: true, run: async () => (await import("../readers/run.mjs")).readFiles() },
	{ name: "integrations", isLong: true, run: async () => (await import("../integrations/run.mjs")).testIntegrations() },
	{ name: "soak", isLong: true, run: longUse },
];
