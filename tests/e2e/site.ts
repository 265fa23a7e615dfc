import { appendFileSync, cpSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, type Page } from "@playwright/test";
import { listFiles } from "../../web/offline_app.mjs";
import { type HostPage, serveUnder } from "./static_server";

const repository = fileURLToPath(new URL("../../", import.meta.url));
/** The page's own policy, which a careful host sends with every file: workers have no other. */
const POLICY = /Policy" content="([^"]+)"/.exec(readFileSync(join(repository, "dist/index.html"), "utf8"))?.[1];

/** The built app on a host of its own, which deploys anew, takes files away and stops. */
export class Site {
	readonly folder: string;
	#server: Awaited<ReturnType<typeof serveUnder>> | undefined;

	constructor(readonly name: string) {
		this.folder = join(repository, "build/e2e-sites", name);
		rmSync(this.folder, { recursive: true, force: true });
		cpSync(join(repository, "dist"), this.folder, { recursive: true });
	}

	async start(pages: Readonly<Record<string, HostPage>> = {}): Promise<string> {
		this.#server = await serveUnder("/plants/", `build/e2e-sites/${this.name}`, pages, POLICY);
		return this.#server.address;
	}

	async stop(): Promise<void> {
		await this.#server?.close();
		this.#server = undefined;
	}

	remove(file: string): void {
		rmSync(join(this.folder, file));
	}

	/** Changes pages as some hosts do, so that they differ from the built ones. */
	rewrite(): void {
		appendFileSync(join(this.folder, "index.html"), "<!-- This host’s own words. -->\n");
	}

	/** The next version: its main script, and any other named, have new names, and none has its old one. */
	deploy(...others: readonly string[]): void {
		const before = listFiles(this.folder);
		const names = ["index", ...others].map((name) => this.#script(name));
		const renamed = (text: string) =>
			names.reduce((all, name) => all.replaceAll(name, `${name.slice(0, -3)}2.js`), text);
		for (const name of names) renameSync(join(this.folder, "assets", name), join(this.folder, "assets", renamed(name)));
		for (const path of Object.keys(listFiles(this.folder))) {
			if (!/(\.js|\.html|^)$/.test(path) || path === "service-worker.js") continue;
			const file = join(this.folder, path || "index.html");
			writeFileSync(file, renamed(readFileSync(file, "utf8")));
		}
		const worker = join(this.folder, "service-worker.js");
		let text = renamed(readFileSync(worker, "utf8")).replace(/(id:[`"'][0-9a-f]{15})./, "$1x");
		const after = listFiles(this.folder);
		for (const [path, integrity] of Object.entries(before)) text = text.replaceAll(integrity, after[renamed(path)]);
		writeFileSync(worker, text);
	}

	#script(name: string): string {
		const found = readdirSync(join(this.folder, "assets")).filter((file) =>
			new RegExp(`^${name}-[\\w-]{8}\\.js$`).test(file),
		);
		if (found.length !== 1) throw new Error(`${found.length} scripts are called ${name}.`);
		return found[0];
	}
}

/** How many builds of the app a page's browser keeps whole. */
export const wholeBuilds = (page: Page): Promise<number> =>
	page.evaluate(async () => {
		const folder = new URL("./", location.href).href;
		const found = (await caches.keys()).map(async (name) => (await caches.open(name)).match(folder));
		return (await Promise.all(found)).filter(Boolean).length;
	});

/** The state of a page's service worker and caches, for the report of a test that waits in vain. */
const storageState = (page: Page): Promise<unknown> =>
	page.evaluate(async () => {
		const registrations = await navigator.serviceWorker.getRegistrations();
		const states = registrations.map(({ installing, waiting, active }) => [installing, waiting, active]);
		const counted = (await caches.keys()).map(async (name) => [name, (await (await caches.open(name)).keys()).length]);
		return {
			workers: states.map((workers) => workers.map((worker) => worker?.state ?? "none")),
			controlled: navigator.serviceWorker.controller !== null,
			caches: Object.fromEntries(await Promise.all(counted)),
			storage: await navigator.storage.estimate(),
			fingerprint: document.querySelector(".fingerprint")?.textContent,
		};
	});

/** Waits until a page's browser keeps one build whole: a machine that is busy takes its time. */
export async function expectStored(page: Page): Promise<void> {
	try {
		await expect.poll(() => wholeBuilds(page), { timeout: 60_000 }).toBe(1);
	} catch (error) {
		throw new Error(`No build is whole: ${JSON.stringify(await storageState(page), undefined, 1)}`, { cause: error });
	}
}
