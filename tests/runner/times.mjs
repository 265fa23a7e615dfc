/** The table of stages and slowest tests that ends a run. */

/**
 * @typedef {{ name: string, seconds: number }} TimedTest
 * @typedef {{ name: string, seconds: number, passed: number, failed: number, tests: TimedTest[] }} StageResult
 */

/**
 * The slowest tests of all stages, slowest first, each with its stage.
 *
 * @param {StageResult[]} results
 * @param {number} count
 * @returns {{ stage: string, name: string, seconds: number }[]}
 */
export function slowest(results, count) {
	return results
		.flatMap(({ name: stage, tests }) => tests.map(({ name, seconds }) => ({ stage, name, seconds })))
		.sort((a, b) => b.seconds - a.seconds)
		.slice(0, count);
}

const seconds = (value) => `${value.toFixed(1).padStart(6)} s`;

/**
 * @param {{ name: string }[]} stages those that were to run
 * @param {StageResult[]} results those that ran
 * @param {{ stage: string, name: string, seconds: number }[]} slow
 * @returns {string}
 */
export function table(stages, results, slow) {
	const rows = stages.map(({ name }) => {
		const result = results.find((each) => each.name === name);
		if (!result) return `  ${name.padEnd(12)} not run`;
		const { passed, failed } = result;
		return `  ${name.padEnd(12)} ${seconds(result.seconds)}  ${passed + failed > 0 ? `${passed} passed, ${failed} failed` : "ok"}`;
	});
	const all = results.reduce((sum, result) => sum + result.seconds, 0);
	rows.push(`  ${"total".padEnd(12)} ${seconds(all)}`);
	if (slow.length > 0) rows.push("", "Slowest tests:");
	for (const test of slow) rows.push(`  ${seconds(test.seconds)}  ${test.stage}: ${test.name}`);
	return rows.join("\n");
}
