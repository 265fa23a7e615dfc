/** The package in browsers, as docs/package.md shows it: bundled by Vite, and served as it is. */
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import type { PanicleSpecimen } from "../../web/src/element/panicle";
import { builtByVite, filesOfPage, type Project, projectWith } from "../package/project";
import { expectSize } from "../sizes/expect_size";
import { grown } from "./element_page";
import { expect, test } from "./fixtures";
import { serveUnder } from "./static_server";

/** The least policy in the documentation, and an icon. */
const POLICY =
	"default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; img-src data:";

let project: Project;
let pages: Record<string, string>;
/** Of the bunch that the examples grow, under Node. */
let fingerprint: string;
test.beforeAll(async () => {
	pages = await filesOfPage();
	project = await projectWith(pages);
	fingerprint = project.run("many.mjs").match(/[0-9a-f]{16}/)?.[0] ?? "none";
});
test.afterAll(() => project.remove());

const below = (folder: string) => pathToFileURL(folder).href;

test("bundled by Vite it grows in a page under a strict policy, in its own workers and in a worker of the page’s", {
	tag: "@long",
}, async ({ page }) => {
	await project.borrow("three");
	const dist = await builtByVite(project);
	const html = await readFile(join(dist, "index.html"), "utf8");
	const host = await serveUnder("/", below(dist), { "index.html": { html, policy: POLICY } });
	const workers: string[] = [];
	page.on("worker", (worker) => workers.push(worker.url()));
	await page.goto(new URL("index.html", host.address).href);
	await expect(page.locator("#words")).toHaveText(
		new RegExp(`^[\\d.]+ cm long, with \\d+ berries, ${fingerprint}, GLB, [1-9]\\d* meshes$`),
	);
	await expect(page.locator("#worker")).toHaveText(`${fingerprint}, model/vnd.usdz+zip`);
	expect(workers.some((url) => /\/assets\/worker-[\w-]+\.js$/.test(url))).toBe(true);
	expect(workers.filter((url) => !url.startsWith(host.address))).toEqual([]);
	await page.goto("about:blank");
	await host.close();
});

test("served as it is, it grows in a page with an import map, and so does its element", {
	tag: "@sizes",
}, async ({ page }) => {
	const scripts = new Set<string>();
	page.on("response", (response) => {
		if (/\.js$/.test(response.url())) scripts.add(response.url());
	});
	const shown = Object.fromEntries(["plain.html", "element.html"].map((name) => [name, { html: pages[name] }]));
	const folder = join(project.folder, "node_modules/panicle");
	const host = await serveUnder("/vendor/panicle/", below(folder), shown);
	await page.goto(new URL("/plain.html", host.address).href);
	await expect(page.locator("#words")).toHaveText(/^Lime leaf, .* of veins, [0-9a-f]{16}$/);
	expect([...scripts].filter((url) => url.includes("element"))).toEqual([]);
	await page.goto("about:blank");
	scripts.clear();
	await page.goto(new URL("/element.html", host.address).href);
	await grown(page);
	expect(
		await page.evaluate(() => document.querySelector<PanicleSpecimen>("panicle-specimen")?.plant?.fingerprint),
	).toBe(fingerprint);
	// Fetched again, because the browser may discard responses.
	const sizes = await Promise.all(
		[...scripts].map(async (url) => gzipSync(Buffer.from(await (await page.request.get(url)).body())).length),
	);
	const bytes = sizes.reduce((sum, size) => sum + size, 0);
	expect(scripts.size).toBeGreaterThan(5);
	// three.js alone is more than this: that scripts were counted at all.
	expect(bytes).toBeGreaterThan(100_000);
	expectSize("element of the package: scripts, gzipped", bytes);
	await host.close();
});
