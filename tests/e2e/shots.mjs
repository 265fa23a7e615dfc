/**
 * `npm run shots`: pictures of the built app as people see it, in build/shots/, to be looked at before a change lands.
 * `npm run shots -- WORD …` takes only those whose name holds a word.
 */
import { mkdirSync } from "node:fs";
import { build, preview } from "vite";
import { launch } from "./browser.mjs";

const folder = new URL("../../build/shots/", import.meta.url);
const DESKTOP = { viewport: { width: 1440, height: 900 } };
const LAPTOP = { viewport: { width: 1024, height: 640 } };
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

/** name, device, address, and what is done before the picture is taken. */
const SHOTS = [
	["desktop", DESKTOP, ""],
	["desktop-shouldered", DESKTOP, "?preset=shouldered-conical&seed=4"],
	["desktop-double", DESKTOP, "?preset=double-bunch-winged"],
	[
		"desktop-stems",
		DESKTOP,
		"?preset=grape-15b",
		(page) => page.getByRole("button", { name: "Show stems only" }).click(),
	],
	[
		"desktop-octahedron",
		DESKTOP,
		"?preset=winged-cylindrical",
		(page) => page.getByRole("button", { name: "Octahedron" }).click(),
	],
	["desktop-menu", DESKTOP, "?preset=lychee&l=900", (page) => page.getByRole("button", { name: "Download" }).click()],
	["desktop-help", DESKTOP, "?preset=redcurrant", (page) => page.keyboard.press("?")],
	["laptop", LAPTOP, ""],
	["phone", PHONE, ""],
	["phone-front", PHONE, "?preset=grape-15c", (page) => page.getByRole("radio", { name: "Front" }).check()],
	["phone-sheet", PHONE, "", (page) => page.locator(".sheet").evaluate((sheet) => sheet.scrollBy(0, 420))],
];

await build({ logLevel: "warn" });
const server = await preview({ preview: { host: "localhost", port: 0 }, logLevel: "warn" });
const browser = await launch();
mkdirSync(folder, { recursive: true });
const words = process.argv.slice(2);
for (const [name, device, search, prepare] of SHOTS) {
	for (const colorScheme of ["light", "dark"]) {
		const file = `${name}-${colorScheme}.png`;
		if (words.length > 0 && !words.some((word) => file.includes(word))) continue;
		const page = await browser.newPage({ ...device, colorScheme });
		await page.goto(new URL(search, server.resolvedUrls.local[0]).href);
		await page.waitForFunction(() => performance.getEntriesByName("first-bunch").length > 0);
		await prepare?.(page);
		await page.waitForLoadState("networkidle");
		await page.waitForTimeout(1200); // The view comes to rest in full resolution.
		await page.screenshot({ path: new URL(file, folder).pathname });
		await page.close();
		console.log(`build/shots/${file}`);
	}
}
await browser.close();
await server.close();
