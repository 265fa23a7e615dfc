/**
 * `npm run pictures -- share`: the picture that previews of links show, as public/share.jpg: the built home page at
 * 1200 × 630 pixels. Run it when the home page or its pictures have changed, and commit the file.
 */
import { statSync } from "node:fs";
import { build, preview } from "vite";
import { launch } from "../browsers/chromium.mjs";

const file = new URL("../../public/share.jpg", import.meta.url);

export async function render() {
	await build({ logLevel: "warn" });
	const server = await preview({ preview: { port: 0 } });
	const browser = await launch();
	const page = await browser.newPage({ viewport: { width: 1200, height: 630 }, colorScheme: "light" });
	await page.goto(server.resolvedUrls.local[0]);
	await page.waitForLoadState("networkidle");
	await page.screenshot({ path: file.pathname, type: "jpeg", quality: 82 });
	console.log(`public/share.jpg: ${(statSync(file).size / 1024).toFixed(0)} kB`);
	await browser.close();
	await server.close();
}
