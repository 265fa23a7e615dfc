/** Ends a run of vitest in which a test blocks its thread. */
import { isLongRun } from "./long_run.mjs";

/** Milliseconds without any news of a file. vitest's own time limits, which are shorter, end a test that waits. */
const LIMIT = isLongRun ? 3_900_000 : 420_000;

/**
 * Watches files of tests. vitest's time limits are timers of the thread that runs the test: they never fire where that thread is in an
 * endless loop, and the whole run would wait for it without a word.
 *
 * @returns {import("vitest/node").Reporter}
 */
function stuckTests() {
	/** By the file's id. @type {Map<string, NodeJS.Timeout>} */
	const timers = new Map();
	/** @param {import("vitest/node").TestModule} module */
	const restart = (module) => {
		clearTimeout(timers.get(module.id));
		const end = () => {
			console.error(`${module.relativeModuleId}: no test ended for ${LIMIT / 60_000} minutes; the run stops.`);
			process.exit(1);
		};
		timers.set(module.id, setTimeout(end, LIMIT).unref());
	};
	return {
		onTestModuleStart: restart,
		onTestCaseReady: ({ module }) => restart(module),
		onTestCaseResult: ({ module }) => restart(module),
		onTestModuleEnd: ({ id }) => {
			clearTimeout(timers.get(id));
			timers.delete(id);
		},
		onTestRunEnd: () => timers.forEach((timer) => void clearTimeout(timer)),
	};
}

/** @returns {import("vitest/node").Vite.Plugin} */
export const endsStuckRuns = () => ({
	name: "ends-stuck-runs",
	configureVitest({ vitest }) {
		vitest.config.reporters.push(/** @type {never} */ (stuckTests()));
	},
});
