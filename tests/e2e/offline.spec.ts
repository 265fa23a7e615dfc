import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { validateBytes } from "gltf-validator";
import { listFiles } from "../../web/offline_app.mjs";
import type { PanicleSpecimen } from "../../web/src/element/panicle";
import { expect, test } from "./fixtures";
import { expectStored, Site, wholeBuilds } from "./site";
import { StudioPage } from "./studio_page";

test.use({ serviceWorkers: "allow" });

const SMALL = "?v=2&preset=redcurrant&seed=7&count=5";
const mainScript = () => document.querySelector<HTMLScriptElement>("script[type=module]")?.src ?? "";

test("the script that answers addresses of specimens draws nothing", () => {
	const assets = "dist/assets";
	const answering = readdirSync(assets).filter((name) => /^specimens-[\w-]{8}\.js$/.test(name));
	expect(answering).toHaveLength(1);
	expect(readFileSync(join(assets, answering[0]), "utf8")).not.toMatch(/webgl2|WebGLRenderer/);
});

test("the built app has each element of the page in one script, because workers have no copy of it", () => {
	const scripts = readdirSync("dist/assets").filter((name) => name.endsWith(".js"));
	const texts = scripts.map((name) => readFileSync(join("dist/assets", name), "utf8"));
	for (const element of ["panicle-long-list", "panicle-constants", "panicle-number"]) {
		const defining = texts.filter((script) => script.includes(`customElements.define(\`${element}\``));
		expect(defining, element).toHaveLength(1);
	}
});

test("after one visit the whole app works without its host", async ({ page, context, complaints }) => {
	const site = new Site("offline");
	const address = await site.start();
	const studio = new StudioPage(page);
	await page.goto(`${address}${SMALL}`);
	await expectStored(page);
	// Browsers install nothing in a window that forgets, as tests have it.
	const { installabilityErrors } = await (await context.newCDPSession(page)).send("Page.getInstallabilityErrors");
	expect(installabilityErrors.map(({ errorId }) => errorId).filter((id) => id !== "in-incognito")).toEqual([]);
	await site.stop();
	// The page requests its service worker and a newer version from its host.
	complaints.expect(/\/plants\/(service-worker\.js)?( net::ERR_CONNECTION_REFUSED|\)$)/);
	await page.goto(`${address}?v=2&preset=lychee`);
	await expect(studio.fingerprint).toHaveText(/^[0-9a-f]{16}$/);
	const { bytes } = await studio.download("glb");
	expect((await validateBytes(bytes)).issues.numErrors).toBe(0);
	for (const [model, preset] of [
		["leaf", "oak"],
		["tree", "oak"],
		["flower", "tulip"],
	])
		await studio.regrown(() => studio.choosePreset(model, preset));
	// Nothing is left out: exporters, pictures, the other pages.
	const files = Object.keys(listFiles(site.folder)).filter(
		(path) => !/^(service-worker|assets\/specimens-)/.test(path),
	);
	const missing = await page.evaluate(async (paths) => {
		const answers = paths.map(async (path) => [
			path,
			await fetch(path || "./").then(
				(answer) => answer.ok,
				() => false,
			),
		]);
		return (await Promise.all(answers)).filter(([, came]) => !came);
	}, files);
	expect(missing).toEqual([]);
});

test("a new version is offered, and old pages keep theirs until they are left", { tag: "@long" }, async ({
	page,
	context,
	complaints,
}) => {
	const site = new Site("versions");
	const address = await site.start();
	const studio = new StudioPage(page);
	await page.goto(`${address}${SMALL}`);
	await expectStored(page);
	const other = await context.newPage();
	complaints.listenTo(other);
	await other.goto(`${address}${SMALL}`);
	await expect(new StudioPage(other).fingerprint).toHaveText(/\w/);
	const old = await other.evaluate(mainScript);
	site.deploy("help");
	await page.reload();
	const fingerprint = await studio.fingerprint.innerText();
	await expect(studio.notices).toContainText("An update is available");
	expect(await page.evaluate(mainScript)).toBe(old);
	await studio.notices.getByRole("button", { name: "Reload" }).click();
	await expect.poll(() => page.evaluate(mainScript).catch(() => old)).not.toBe(old);
	await expect(studio.fingerprint).toHaveText(fingerprint);
	// The other tab was not changed, and its later requests succeed.
	expect(await other.evaluate(mainScript)).toBe(old);
	await other.getByRole("button", { name: "Help" }).click();
	await expect(other.getByRole("dialog")).toBeVisible();
	expect(await wholeBuilds(page)).toBe(2);
	await other.close();
	await page.reload();
	await expectStored(page);
	await expect(studio.notices).not.toContainText("An update is available");
	await page.goto("about:blank");
	await site.stop();
});

test("a host that rewrites its pages, or removes the worker, leaves no visitor with an old version", {
	tag: "@long",
}, async ({ page, complaints }) => {
	const site = new Site("rewritten");
	const address = await site.start();
	const studio = new StudioPage(page);
	await page.goto(`${address}${SMALL}`);
	await expectStored(page);
	const old = await page.evaluate(mainScript);
	site.deploy();
	site.rewrite();
	await page.reload();
	await studio.notices.getByRole("button", { name: "Reload" }).click();
	await expect.poll(() => page.evaluate(mainScript).catch(() => old)).not.toBe(old);
	const workers = () => page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length);
	await expect.poll(workers).toBe(1);
	site.remove("service-worker.js");
	complaints.expect(/404/);
	await page.reload();
	await expect.poll(workers).toBe(0);
	expect(await page.evaluate(() => caches.keys())).toEqual([]);
	await page.goto("about:blank");
	await site.stop();
});

test.describe("without a service worker", () => {
	test.use({ serviceWorkers: "block" });

	test("a script that a deploy took away is made good by the new version, with the plant", { tag: "@long" }, async ({
		page,
		complaints,
	}) => {
		const site = new Site("deployed");
		const address = await site.start();
		const studio = new StudioPage(page);
		await page.goto(`${address}${SMALL}`);
		await expect(studio.fingerprint).toHaveText(/\w/);
		const fingerprint = await studio.fingerprint.innerText();
		site.deploy("help");
		complaints.expect(/404/);
		await studio.button("Help").click();
		await expect(studio.notices).toContainText("The help could not be loaded");
		await studio.notices.getByRole("button", { name: "Reload" }).click();
		await expect(studio.fingerprint).toHaveText(fingerprint);
		await studio.button("Help").click();
		await expect(page.getByRole("dialog")).toBeVisible();
		await page.goto("about:blank");
		await site.stop();
	});
});

test("a specimen that takes long holds up none of the app's files: a page grows it", { tag: "@long" }, async ({
	page,
}) => {
	const site = new Site("heavy");
	const html = `<!doctype html><title>Plants</title><link rel="icon" href="icons/panicle.svg">`;
	const address = await site.start({ "plants/mine.html": { html } });
	await page.goto(`${address}mine.html`);
	await page.evaluate(async () => (await import(new URL("specimens.js", location.href).href)).ready);
	const order = await page.evaluate(async () => {
		const order: string[] = [];
		const get = async (name: string, path: string) => {
			const { status } = await fetch(path);
			order.push(`${name} ${status}`);
		};
		const plant = get("plant", "specimens/riesling.low.glb?count=1500");
		// By then it grows.
		await new Promise((resolve) => setTimeout(resolve, 500));
		for (let i = 0; i < 5; i++) await get("file", "icons/panicle.svg");
		order.push("files are there");
		await plant;
		return order;
	});
	expect(order).toEqual([...Array.from({ length: 5 }, () => "file 200"), "files are there", "plant 200"]);
	expect(page.workers().map((worker) => worker.url())).toEqual([
		expect.stringMatching(/assets\/specimens-[\w-]{8}\.js$/),
	]);
	await page.goto("about:blank");
	await site.stop();
});

test("the plant of a frame keeps its scripts while newer versions come", { tag: "@long" }, async ({
	page,
	context,
}) => {
	const site = new Site("frames");
	const address = await site.start();
	const studio = new StudioPage(page);
	await page.goto(`${address}${SMALL}`);
	await expectStored(page);
	const frame = await context.newPage();
	await frame.goto(`${address}embed.html${SMALL}`);
	await frame.waitForFunction(() => document.querySelector<PanicleSpecimen>("panicle-specimen")?.plant);
	const old = await page.evaluate(mainScript);
	site.deploy("exporter");
	await page.reload();
	await studio.notices.getByRole("button", { name: "Reload" }).click();
	await expect.poll(() => page.evaluate(mainScript).catch(() => old)).not.toBe(old);
	await expect(studio.fingerprint).toHaveText(/\w/);
	// The cache of a build of which nothing is open: gone once the worker has looked for such.
	const stray = `panicle ${address} stray`;
	await page.evaluate((name) => caches.open(name), stray);
	await page.reload();
	await expect.poll(() => page.evaluate((name) => caches.has(name), stray)).toBe(false);
	const size = await frame.evaluate(async () => {
		const plant = document.querySelector<PanicleSpecimen>("panicle-specimen");
		return (await plant?.toFile("glb"))?.size;
	});
	expect(size).toBeGreaterThan(1000);
	expect(await wholeBuilds(page)).toBe(2);
	await page.goto("about:blank");
	await site.stop();
});

test("a page of the same host has specimens by their addresses, with and without it", { tag: "@long" }, async ({
	page,
	complaints,
}) => {
	complaints.expect(/404.*no-such/);
	const site = new Site("specimens");
	const html = `<!doctype html><title>Plants</title><link rel="icon" href="icons/panicle.svg"><img alt="An oak’s leaf">`;
	const address = await site.start({ "plants/mine.html": { html } });
	// The page of a frame keeps nothing in its visitors' browsers.
	await page.goto(`${address}embed.html?preset=redcurrant&count=5`);
	await page.waitForFunction(() => document.querySelector<PanicleSpecimen>("panicle-specimen")?.plant);
	expect(await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length)).toBe(0);
	await page.goto(`${address}mine.html`);
	const ready = () => page.evaluate(async () => (await import(new URL("specimens.js", location.href).href)).ready);
	await ready();
	// A page has specimens without the whole app's being fetched.
	expect(await wholeBuilds(page)).toBe(0);
	const get = async (path: string, headers: Record<string, string> = {}) => {
		const { text, ...answer } = await page.evaluate(
			async ([address, sent]) => {
				const answer = await fetch(address, { headers: sent });
				const bytes = new Uint8Array(await answer.arrayBuffer());
				const text = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
				return { status: answer.status, etag: answer.headers.get("etag") ?? "", text };
			},
			[path, headers] as const,
		);
		return { ...answer, bytes: Buffer.from(text, "latin1") };
	};
	const query = "seed=7&count=5";
	const json = await get(`specimens/redcurrant.json?${query}`);
	const { fingerprint } = JSON.parse(json.bytes.toString());
	const again = await get(`specimens/redcurrant.json?${query}`, { "if-none-match": json.etag });
	expect([again.status, again.bytes.length]).toEqual([304, 0]);
	const glb = await get(`specimens/redcurrant.glb?${query}`);
	expect(glb.status).toBe(200);
	expect((await validateBytes(glb.bytes)).issues.numErrors).toBe(0);
	expect((await get("specimens/no-such.glb")).status).toBe(404);
	await page.goto(`${address}?v=2&preset=redcurrant&${query}`);
	await expect(new StudioPage(page).fingerprint).toHaveText(fingerprint);
	await expectStored(page);
	await page.goto(`${address}mine.html`);
	await ready();
	await site.stop();
	await page.locator("img").evaluate((image: HTMLImageElement) => {
		image.src = "specimens/leaf/oak.svg";
		return image.decode();
	});
});
