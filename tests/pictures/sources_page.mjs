/** Pages of the app's sources as Vite serves them, for scripts that run modules of ours in a browser: `import("/src/…")` there. */
import { createServer } from "vite";
import { launch } from "../browsers/chromium.mjs";

/**
 * Opens pages until `close` is called. Nothing loads them anew while they draw: no watching, no bundling of packages behind their backs.
 * @returns {Promise<{ page: (options?: import("@playwright/test").BrowserContextOptions) => Promise<import("@playwright/test").Page>, close: () => Promise<void> }>}
 */
export async function openSources() {
	const server = await createServer({
		server: { host: "localhost", port: 0, hmr: false, watch: null },
		optimizeDeps: { noDiscovery: true, include: [] },
		logLevel: "warn",
	});
	await server.listen();
	const browser = await launch();
	return {
		async page(options = {}) {
			const page = await browser.newPage({ viewport: { width: 600, height: 600 }, ...options });
			await page.goto(server.resolvedUrls.local[0]);
			return page;
		},
		async close() {
			await browser.close();
			await server.close();
		},
	};
}
