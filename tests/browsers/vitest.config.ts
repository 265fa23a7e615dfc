import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

/** The built app in browsers besides Chromium: `npm test -- browsers`. No test is tried twice. */
export default defineConfig({
	root: fileURLToPath(new URL("../..", import.meta.url)),
	test: {
		include: ["tests/browsers/*.test.ts"],
		testTimeout: 180_000,
		hookTimeout: 120_000,
		pool: "forks",
		// Both browsers at the same time.
		maxWorkers: 2,
		// Node has WebSocket without a flag since version 22.
		execArgv: typeof WebSocket === "undefined" ? ["--experimental-websocket"] : [],
	},
});
