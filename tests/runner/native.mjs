/** The core's own tests, built natively. */
import { availableParallelism } from "node:os";
import { join } from "node:path";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { run } from "../../wasm-core/tools/process.mjs";
import { buildFolder } from "../../wasm-core/tools/repository.mjs";
import { StageError } from "./process.mjs";

/** A program's cases are divided into this many runs; as many run at a time as there are processors. */
const RUNS = 12;

/** Cases of the suite `long` run only in the long run. */
const filters = () => (process.env.PANICLE_LONG === "1" ? [] : ["--test-suite-exclude=long"]);

/**
 * Builds and runs programs of native tests.
 *
 * @param {string} preset
 * @param {string[]} programs
 * @param {string[]} [sanitizeRooms] rooms to build with sanitizers, of preset `native`
 */
export async function nativeTests(preset, programs, sanitizeRooms) {
	// Goldens compare native plants with those of the wasm.
	await buildCore(preset, [...programs, "native_grow"], { sanitizeRooms });
	const total = { passed: 0, failed: 0, tests: [] };
	for (const program of programs) {
		for (const { passed, failed, tests } of await runProgram(join(buildFolder, preset, program))) {
			total.passed += passed;
			total.failed += failed;
			total.tests.push(...tests);
		}
	}
	return total;
}

/** Runs every case of a program, in several parallel runs; shows failures. */
async function runProgram(program) {
	const { output } = await run(program, ["--no-colors", "--count", ...filters()]);
	const cases = Number(/filters: (\d+)/.exec(output)?.[1]);
	if (!(cases > 0)) throw new StageError(`${program} has no tests`);
	const firsts = Array.from({ length: RUNS }, (_, i) => Math.floor((i * cases) / RUNS) + 1);
	const waiting = firsts.map((first, i) => ({ first, last: (firsts[i + 1] ?? cases + 1) - 1 }));
	const results = [];
	const work = async () => {
		for (let range = waiting.shift(); range; range = waiting.shift()) results.push(await runRange(program, range));
	};
	await Promise.all(Array.from({ length: availableParallelism() }, work));
	return results;
}

async function runRange(program, { first, last }) {
	if (last < first) return { passed: 0, failed: 0, tests: [] };
	const words = ["--no-colors", "--duration=true", `--first=${first}`, `--last=${last}`, ...filters()];
	const { status, output } = await run(program, words);
	const counts = /test cases: +\d+ \| +\d+ passed \| +(\d+) failed/.exec(output);
	if (status !== 0) console.log(output.replace(/^\d+\.\d+ s: .*\n/gm, ""));
	if (!counts)
		throw new StageError(`${program}, cases ${first} to ${last}: ended with status ${status} before its summary`);
	// The summary counts the cases outside of the range as passed.
	const failed = Math.max(Number(counts[1]), status === 0 ? 0 : 1);
	const timed = [...output.matchAll(/^(\d+\.\d+) s: (.*)$/gm)];
	const tests = timed.map(([, seconds, name]) => ({ name, seconds: Number(seconds) }));
	return { passed: last - first + 1 - failed, failed, tests };
}
