import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { configDefaults, defineConfig } from "vitest/config";
import { isLongRun } from "./tests/long_run.mjs";
import { endsStuckRuns } from "./tests/stuck_tests.mjs";

const at = (path: string) => fileURLToPath(new URL(path, import.meta.url));

const TESTS = ["tests/{web,golden,fuzz,tools,toy,package,docs,language}/**/*.test.ts", "tests/*.test.ts"];

/** Files that replace modules or add models: what they change would stay for the next file of the thread. */
const CHANGES_MODULES = /\bvi\.(?:mock|doMock|resetModules)\(|\baddModel\(/;
/** Files that need modules in their first state, such as a cache in which nothing has been fetched yet. */
const FIRST_STATE = ["tests/web/models/bunch/leaf.test.ts", "tests/golden/bunch.test.ts"];

const isolated = readdirSync(at("tests"), { recursive: true, encoding: "utf8" })
	.map((file) => `tests/${file.replaceAll("\\", "/")}`)
	.filter((file) => file.endsWith(".test.ts"))
	.filter((file) => FIRST_STATE.includes(file) || CHANGES_MODULES.test(readFileSync(at(file), "utf8")));

/** A file `*.long.test.ts` runs in `npm run test:long` alone. */
const exclude = [...configDefaults.exclude, ...(isLongRun ? [] : ["**/*.long.test.ts"])];

export default defineConfig({
	publicDir: at("public"),
	base: "./",
	plugins: [endsStuckRuns()],
	test: {
		globalSetup: at("tests/run_setup.ts"),
		setupFiles: [at("tests/file_setup.ts")],
		// Ends tests that hang; far above the time of any test.
		testTimeout: 300_000,
		hookTimeout: 300_000,
		expect: { poll: { timeout: 240_000 } },
		pool: "threads",
		// All processors: the default leaves one of two idle.
		maxWorkers: "100%",
		projects: [
			{
				// One module graph a thread: importing the sources again for every file takes longer than most tests.
				extends: true,
				test: {
					name: "shared",
					root: at("."),
					include: TESTS,
					exclude: [...exclude, ...isolated],
					isolate: false,
					sequence: { groupOrder: 1 },
				},
			},
			{
				extends: true,
				test: {
					name: "isolated",
					root: at("."),
					include: isolated,
					exclude,
					isolate: true,
					sequence: { groupOrder: 0 },
				},
			},
		],
	},
});
