/**
 * `npm run pictures -- shots [WORD …]`: pictures of the built app at several window sizes, in build/shots/, to be looked at
 * before a change lands. With words, only those pictures whose name contains one of them.
 */

import { mkdirSync } from "node:fs";
import { build, preview } from "vite";
import { launch } from "../browsers/chromium.mjs";
import { withoutHints } from "../e2e/without_hints.mjs";

const folder = new URL("../../build/shots/", import.meta.url);
const DESKTOP = { viewport: { width: 1440, height: 900 } };
const LAPTOP = { viewport: { width: 1024, height: 640 } };
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };
/** Windows that are both narrow and low: a laptop at 200 % and 400 %, a phone on its side. */
const ZOOMED = { viewport: { width: 720, height: 450 } };
const SIDEWAYS = { ...PHONE, viewport: { width: 667, height: 375 } };
const SMALLEST = { viewport: { width: 320, height: 256 } };

/** Name, device, address, and actions before the picture. */
const SHOTS = [
	["desktop", DESKTOP, ""],
	["desktop-shouldered", DESKTOP, "?v=2&preset=shouldered-conical&seed=4"],
	["desktop-double", DESKTOP, "?v=2&preset=double-bunch-winged"],
	["desktop-paper", DESKTOP, "?v=1&preset=grape-15b"],
	["desktop-flower", DESKTOP, "?v=2&preset=riesling&age=6"],
	["desktop-colouring", DESKTOP, "?v=2&preset=tempranillo&age=72"],
	["desktop-numbers", DESKTOP, "?v=2&preset=pinot-noir", (page) => onlyGroup(page, "numbers")],
	["desktop-thin", DESKTOP, "?v=2&preset=red-globe", thin],
	["desktop-stems", DESKTOP, "?v=2&preset=grape-15b", (page) => press(page, "Hide berries")],
	["desktop-octahedron", DESKTOP, "?v=2&preset=winged-cylindrical", (page) => press(page, "Outline in 3D")],
	["desktop-download", DESKTOP, "?v=2&preset=lychee&l=900", (page) => press(page, "Download")],
	["desktop-share", DESKTOP, "?v=2&preset=lychee&l=900", (page) => press(page, "Share")],
	["phone-download", PHONE, "?v=2&preset=lychee&l=900", (page) => press(page, "Download")],
	["phone-share", PHONE, "?v=2&preset=lychee&l=900", (page) => press(page, "Share")],
	["desktop-help", DESKTOP, "?v=2&preset=redcurrant", (page) => page.keyboard.press("?")],
	["laptop", LAPTOP, ""],
	["phone", PHONE, ""],
	["phone-front", PHONE, "?v=2&preset=grape-15c", (page) => page.getByRole("radio", { name: "Front" }).check()],
	["phone-sheet", PHONE, "", (page) => page.locator(".sheet").evaluate((sheet) => sheet.scrollBy(0, 420))],
	["zoomed", ZOOMED, ""],
	["aside", SIDEWAYS, ""],
	["smallest", SMALLEST, ""],
	["phone-numbers", PHONE, "?v=2&preset=shine-muscat&age=80", (page) => onlyGroup(page, "numbers")],
];

const press = (page, name) => page.getByRole("button", { name, exact: true }).click();

/** Closes every group but one, and brings that into sight. */
async function onlyGroup(page, key) {
	for (const group of await page.locator("details.group").all()) {
		const open = (await group.getAttribute("open")) !== null;
		if (open !== ((await group.getAttribute("data-group")) === key)) await group.locator("> summary").click();
	}
	await page.locator(`details[data-group=${key}]`).evaluate((group) => group.scrollIntoView());
}

/** The mode for thinning, and the pointer over a berry. */
async function thin(page) {
	await press(page, "Remove berries");
	const { x, y, width, height } = await page.locator("canvas").boundingBox();
	await page.mouse.move(x + width / 2, y + height / 2);
}

/** @param {string[]} words parts of the names of the pictures; none: all */
export async function render(words) {
	await build({ logLevel: "warn" });
	const server = await preview({ preview: { host: "localhost", port: 0 }, logLevel: "warn" });
	const browser = await launch();
	mkdirSync(folder, { recursive: true });
	for (const [name, device, search, prepare] of SHOTS) {
		for (const colorScheme of ["light", "dark"]) {
			const file = `${name}-${colorScheme}.png`;
			if (words.length > 0 && !words.some((word) => file.includes(word))) continue;
			const page = await browser.newPage({ ...device, colorScheme });
			await page.addInitScript(withoutHints);
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
}
