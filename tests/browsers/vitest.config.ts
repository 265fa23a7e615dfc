import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

/** The built app in browsers besides Chromium: `npm test -- browsers`. */
export default defineConfig({
	root: fileURLToPath(new URL("../..", import.meta.url)),
	test: {
		include: ["tests/browsers/*.test.ts"],
		testTimeout: 180_000,
		// As in playwright.config.ts.
		retry: process.env.CI ? 1 : 0,
		hookTimeout: 120_000,
		pool: "forks",
		// A browser beside the other, each on a processor.
		maxWorkers: 2,
		// Node has had it without a flag since version 22.
		execArgv: typeof WebSocket === "undefined" ? ["--experimental-websocket"] : [],
	},
});
