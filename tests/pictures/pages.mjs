/**
 * `npm run pictures -- pages`: the pictures of the pages docs/for-*.md, as docs/people/*.jpg: the built app, and HTML pages that
 * are examples there, served as those pages describe. Run it when the app or the examples have changed their looks.
 */

import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { build, preview } from "vite";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { launch } from "../browsers/chromium.mjs";
import { withoutHints } from "../e2e/without_hints.mjs";

const LARGEST = 90 * 1024;
const WINDOW = { width: 1080, height: 675 };

/** Name, window size, address, and actions before the picture. */
const PICTURES = [
	["artists", WINDOW, "panicle/?v=2&preset=merlot&seed=7", downloads],
	["game-developers", { width: 960, height: 540 }, "field.html", (page) => page.getByText("200 bunches").waitFor()],
	[
		"web-authors",
		{ width: 316, height: 416 },
		"plant.html",
		(page) => page.getByRole("button", { name: "Turn" }).waitFor(),
	],
	["researchers", WINDOW, "panicle/?v=2&preset=riesling&seed=7", numbers],
	[
		"teachers",
		WINDOW,
		"panicle/?v=1&preset=grape-15b",
		(page) => page.getByRole("button", { name: "Hide berries" }).click(),
	],
];

/** The download sheet, when it shows the sizes of the recommended files, which are made first. */
async function downloads(page) {
	await page.getByRole("button", { name: "Download", exact: true }).click();
	const isReady = () => {
		const sizes = [...document.querySelectorAll("dialog[open] .purposes .size")];
		return sizes.length > 0 && !sizes.some((size) => size.textContent === "…");
	};
	await page.waitForFunction(isReady, undefined, { timeout: 120_000 });
}

/** Shows the measures in place of the parameters. */
async function numbers(page) {
	for (const group of await page.locator("details.group").all()) {
		const wanted = (await group.getAttribute("data-group")) === "numbers";
		if (((await group.getAttribute("open")) !== null) !== wanted) await group.locator("> summary").click();
	}
	await page.locator("details[data-group=numbers]").evaluate((group) => group.scrollIntoView());
}

/** A host's folder: the app, three.js, the page's example, and the files that the page has grown for it. */
function site() {
	const folder = mkdtempSync(join(tmpdir(), "panicle-people-"));
	mkdirSync(join(folder, "vendor"));
	symlinkSync(join(repository, "dist"), join(folder, "panicle"));
	symlinkSync(join(repository, "node_modules/three"), join(folder, "vendor/three"));
	for (const page of ["game-developers", "web-authors"]) {
		const text = readFileSync(join(repository, `docs/for-${page}.md`), "utf8");
		for (const [, title, code] of text.matchAll(/^```html title="([^"]+)"\n([\s\S]*?)^```$/gm))
			writeFileSync(join(folder, title), code);
		for (const [, words] of text.matchAll(/^npm run -s grow -- (.* --out bunches)$/gm))
			execFileSync(process.execPath, [join(repository, "wasm-core/tools/grow.mjs"), ...words.split(" ")], {
				cwd: folder,
				stdio: "inherit",
			});
	}
	return folder;
}

export async function render() {
	await build({ logLevel: "warn" });
	const root = site();
	const out = join(repository, "docs/people");
	mkdirSync(out, { recursive: true });
	const own = { configFile: /** @type {const} */ (false), root, build: { outDir: "." } };
	const server = await preview({ ...own, preview: { host: "localhost", port: 0 }, logLevel: "warn" });
	const browser = await launch();
	try {
		for (const picture of PICTURES) await take({ browser, server, out }, picture);
	} finally {
		await browser.close();
		await server.close();
		rmSync(root, { recursive: true });
	}
}

async function take({ browser, server, out }, [name, viewport, address, prepare]) {
	const page = await browser.newPage({ viewport, colorScheme: "light" });
	await page.addInitScript(withoutHints);
	await page.goto(new URL(address, server.resolvedUrls.local[0]).href);
	if (address.startsWith("panicle/"))
		await page.waitForFunction(() => performance.getEntriesByName("first-bunch").length > 0);
	await prepare(page);
	await page.waitForLoadState("networkidle");
	await page.waitForTimeout(2500); // The view comes to rest in full resolution.
	const path = join(out, `${name}.jpg`);
	await page.screenshot({ path, type: "jpeg", quality: 74 });
	await page.close();
	const { size } = statSync(path);
	if (size > LARGEST) throw new Error(`${name}.jpg has ${size} bytes; lower the quality.`);
	console.log(`docs/people/${name}.jpg: ${(size / 1024).toFixed(0)} kB`);
}
