import { defineConfig } from "@playwright/test";
import { isLongRun } from "./tests/long_run.mjs";
import { locate } from "./wasm-core/tools/toolchain.mjs";

const port = Number(process.env.PANICLE_PORT ?? 4173);
const origin = `http://localhost:${port}`;
const { chromium } = locate(["chromium"]).found;

// WebGL 2 by software rendering, so that no graphics card is needed. The sandbox does not start for root.
const flags = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
// The page around the canvas is composited without WebGL.
flags.push("--disable-gpu-compositing");
// The pop-up pages of the address bar, which each window loads: a quarter of the cost of a window. Chromium uses only the last
// `--disable-features`, so the features that Playwright disables are repeated here.
const playwrights = "HttpsUpgrades,MediaRouter,PaintHolding,ThirdPartyStoragePartitioning,DestroyProfileOnBrowserClose";
const background = "OptimizationHints,NetworkTimeServiceQuerying,AimEnabled,PreconnectToSearch,LensOverlay";
const popups = "WebUIOmniboxPopup,WebUIOmniboxAimPopup";
flags.push(`--disable-features=${playwrights},${background},AvoidUnnecessaryBeforeUnloadCheckSync,${popups}`);
if (process.getuid?.() === 0) flags.push("--no-sandbox");

/**
 * End-to-end tests: the built app in dist/, in the system's Chromium. Tests with the tag `@long` run only in the long run
 * (`PANICLE_LONG=1`).
 *
 * Each test has a browser context of its own. Sharing one (`reuseContext`) was measured: it saves 8 % of the processor time.
 */
export default defineConfig({
	testDir: "tests/e2e",
	testMatch: "**/*.spec.ts",
	outputDir: "build/e2e",
	...(isLongRun ? {} : { grepInvert: /@long\b/ }),
	workers: 2,
	forbidOnly: !!process.env.CI,
	// The second try in CI only tells flaky tests from broken ones in the report: the run fails with either.
	retries: process.env.CI ? 1 : 0,
	failOnFlakyTests: true,
	timeout: 120_000,
	expect: { timeout: 15_000 },
	reporter: process.env.PANICLE_E2E_REPORT
		? [["line"], ["json", { outputFile: process.env.PANICLE_E2E_REPORT }]]
		: "list",
	use: {
		baseURL: origin,
		browserName: "chromium",
		// Service workers fetch the whole app after the first load; offline.spec.ts allows them.
		serviceWorkers: "block",
		// Software rendering takes time in proportion to the pixels.
		viewport: { width: 800, height: 500 },
		launchOptions: { executablePath: chromium, args: flags },
		screenshot: "only-on-failure",
	},
	webServer: {
		command: `node node_modules/vite/bin/vite.js preview --host localhost --port ${port} --strictPort`,
		url: origin,
		reuseExistingServer: false,
	},
});
