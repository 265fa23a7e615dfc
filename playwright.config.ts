import { defineConfig } from "@playwright/test";
import { locate } from "./wasm-core/tools/toolchain.mjs";

const port = Number(process.env.PANICLE_PORT ?? 4173);
const origin = `http://localhost:${port}`;
const { chromium } = locate(["chromium"]).found;

// WebGL 2 on any machine, with or without a graphics card. The sandbox cannot start for the superuser.
const flags = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
// The page around the canvas needs no graphics card, nor one that software acts.
flags.push("--disable-gpu-compositing");
// The pages that each window loads to suggest addresses below its bar, which nobody sees: a quarter of what a window costs. Of several
// lists the last one counts, so Playwright's own is said again as far as our pages are concerned.
const playwrights = "HttpsUpgrades,MediaRouter,PaintHolding,ThirdPartyStoragePartitioning,DestroyProfileOnBrowserClose";
const unasked = "OptimizationHints,NetworkTimeServiceQuerying,AimEnabled,PreconnectToSearch,LensOverlay";
const suggestions = "WebUIOmniboxPopup,WebUIOmniboxAimPopup";
flags.push(`--disable-features=${playwrights},${unasked},AvoidUnnecessaryBeforeUnloadCheckSync,${suggestions}`);
if (process.getuid?.() === 0) flags.push("--no-sandbox");

/** End-to-end tests: the built app in dist/, in the system's Chromium. */
export default defineConfig({
	testDir: "tests/e2e",
	testMatch: "**/*.spec.ts",
	outputDir: "build/e2e",
	// A test waits more than it works.
	workers: 2,
	forbidOnly: !!process.env.CI,
	// Where nobody watches, what fails is tried once more; what passes then is named as flaky.
	retries: process.env.CI ? 1 : 0,
	timeout: 120_000,
	expect: { timeout: 15_000 },
	reporter: process.env.PANICLE_E2E_REPORT
		? [["line"], ["json", { outputFile: process.env.PANICLE_E2E_REPORT }]]
		: "list",
	use: {
		baseURL: origin,
		browserName: "chromium",
		// What is tested is the page that was just built, and nothing is fetched beside it; offline.spec.ts allows them.
		serviceWorkers: "block",
		// Software rendering pays by the pixel.
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
