/** Observes a page of the app: errors, activity and resources. */
import { setTimeout as delay } from "node:timers/promises";

/** The page's thread may not be blocked for longer, in milliseconds. */
const LONGEST_BLOCK = 5000;
/** A page that has not answered after this time has hung, in milliseconds. */
const HUNG = 60_000;
/** An action with the plant that grows from it may take so long, in milliseconds: a busy machine takes its time. */
const LONGEST_WORK = 240_000;
/** How often one action may request the same address; more is a request that is repeated without end. */
const MAX_REPEATS = 25;
/** Errors that a browser reports for requests while offline; no other errors are expected. */
const OFFLINE_ERRORS = [
	"Failed to load resource: net::ERR_INTERNET_DISCONNECTED",
	"Failed to load resource: net::ERR_FAILED",
	"An unknown error occurred when fetching the script.",
];
/** Requests that were under way when the network came back fail within this time, in milliseconds. */
const OFFLINE_AFTER = 3000;

/** Workers that are not needed end after this time, in milliseconds (core/pool.ts). */
const REST = 5000;

/** A fault of the page, found by random use. */
export class Fault extends Error {}

/** In the page, before its own scripts: keeps the contexts that draw in 3-D, to be lost, and the length of the longest task. */
function observe() {
	const contexts = [];
	window.webglContexts = contexts;
	window.longestTask = 0;
	new PerformanceObserver((list) => {
		for (const { duration } of list.getEntries()) window.longestTask = Math.max(window.longestTask, duration);
	}).observe({ type: "longtask", buffered: true });
	const { getContext } = HTMLCanvasElement.prototype;
	HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
		const context = getContext.call(this, kind, ...rest);
		if (kind === "webgl2" && context) contexts.push(new WeakRef(context));
		return context;
	};
}

/** In the page: the longest task since the last call, in milliseconds. */
function takeLongestTask() {
	const { longestTask } = window;
	window.longestTask = 0;
	return longestTask ?? 0;
}

export class WatchedPage {
	/** @type {string[]} */
	#faults = [];
	/** How often each address has been requested since the action began. @type {Map<string, number>} */
	#requests = new Map();
	#loads = 1;
	#online = true;
	#onlineSince = 0;

	/**
	 * @param {import("@playwright/test").Page} page
	 * @param {import("@playwright/test").CDPSession} devtools
	 * @param {string} address of the app
	 */
	constructor(page, devtools, address) {
		this.page = page;
		this.devtools = devtools;
		this.address = address;
	}

	/**
	 * Opens the app in a browser and waits for its first plant.
	 *
	 * @param {import("@playwright/test").BrowserContext} context
	 * @param {string} address
	 * @param {() => void} [withoutDrawing] runs in the page before its scripts
	 */
	static async open(context, address, withoutDrawing) {
		if (withoutDrawing) await context.addInitScript(withoutDrawing);
		await context.addInitScript(observe);
		const page = await context.newPage();
		const watched = new WatchedPage(page, await context.newCDPSession(page), address);
		await watched.#listen();
		await page.goto(address);
		await watched.settled();
		return watched;
	}

	async #listen() {
		const { page, devtools } = this;
		await devtools.send("Performance.enable");
		page.on("console", (message) => {
			if (message.type() === "error") this.#report(message.text(), `console (${message.location().url})`);
		});
		page.on("pageerror", (error) => this.#report(error.stack ?? error.message, "uncaught"));
		page.on("crash", () => this.#report("the page crashed", "browser"));
		page.on("request", (request) => this.#requests.set(request.url(), (this.#requests.get(request.url()) ?? 0) + 1));
		page.on("dialog", (dialog) => dialog.dismiss());
		page.on("popup", (other) => other.close().catch(() => {}));
		page.on("download", (download) => download.cancel().catch(() => {}));
	}

	#report(text, source) {
		const isOffline = !this.#online || Date.now() - this.#onlineSince < OFFLINE_AFTER;
		if (isOffline && OFFLINE_ERRORS.includes(text)) return;
		this.#faults.push(`${source}: ${text}`);
	}

	get isOnline() {
		return this.#online;
	}

	/** Switches the network on or off. */
	async setOnline(online) {
		if (online && !this.#online) this.#onlineSince = Date.now();
		await this.page.context().setOffline(!online);
		this.#online = online;
	}

	/** How often the page has been loaded. */
	get loads() {
		return this.#loads;
	}

	/** Loads the page again. */
	async reload() {
		this.#loads++;
		await this.page.reload();
		await this.settled();
	}

	/**
	 * Does something with the page and checks the page afterwards.
	 *
	 * @param {() => Promise<unknown>} act
	 * @throws {Fault} where the page has reported an error, its thread was blocked, it does not answer, or it repeats a request
	 */
	async during(act) {
		this.#requests.clear();
		const { ThreadTime: before } = await this.#metrics();
		await this.#watched(act());
		// Rejects where the page is loaded again meanwhile.
		const longest = await this.#watched(this.page.evaluate(takeLongestTask).catch(() => 0));
		const { ThreadTime: now } = await this.#metrics();
		// A busy machine delays a task: only the time that the thread has worked is the page's own.
		const blocked = Math.min(longest, 1000 * (now - before));
		if (blocked > LONGEST_BLOCK) throw new Fault(`The page's thread was blocked for ${Math.round(blocked)} ms.`);
		for (const [url, times] of this.#requests)
			if (times > MAX_REPEATS) throw new Fault(`One action requested ${url} ${times} times.`);
		if (this.#faults.length > 0) throw new Fault(this.#faults.join("\n"));
	}

	/**
	 * Resets the page to its default plant, online and without a dialog, and waits until its workers are idle.
	 *
	 * @returns {Promise<import("./held.mjs").Held>} the page's resources then
	 */
	async held() {
		const { page, devtools } = this;
		await this.setOnline(true);
		for (let i = 0; i < 3; i++) await page.keyboard.press("Escape");
		await page.evaluate(() => {
			for (const dialog of document.querySelectorAll("dialog[open]")) dialog.close();
			history.pushState(null, "", "?v=2");
			dispatchEvent(new PopStateEvent("popstate"));
		});
		await this.settled();
		await delay(REST);
		await devtools.send("HeapProfiler.collectGarbage");
		const { JSHeapUsedSize, Nodes, JSEventListeners } = await this.#metrics();
		return {
			heap: JSHeapUsedSize / 1e6,
			nodes: Nodes,
			listeners: JSEventListeners,
			workers: page.workers().length,
		};
	}

	/** Waits until the plant on the controls is the one in view. */
	async settled() {
		await this.#watched(this.page.waitForSelector("[data-fingerprint]", { state: "attached", timeout: LONGEST_WORK }));
		await this.#watched(this.page.waitForSelector(".growing", { state: "detached", timeout: LONGEST_WORK }));
	}

	/** @returns {Promise<Record<string, number>>} */
	async #metrics() {
		const { metrics } = await this.#watched(this.devtools.send("Performance.getMetrics"));
		return Object.fromEntries(metrics.map(({ name, value }) => [name, value]));
	}

	/**
	 * Waits for work on the page while the page answers.
	 *
	 * @template T
	 * @param {Promise<T>} work
	 * @returns {Promise<T>}
	 * @throws {Fault} where the page has hung or the work takes too long
	 */
	async #watched(work) {
		const start = Date.now();
		let isDone = false;
		const end = () => {
			isDone = true;
		};
		const ended = work.then(end, end);
		while (!isDone) {
			// Rejects where the page is loaded again meanwhile, which is an answer, too.
			const answer = this.page.evaluate("0").catch(() => undefined);
			const late = delay(HUNG, "late", { ref: false });
			if ((await Promise.race([ended, answer, late])) === "late")
				throw new Fault(`The page has not answered for ${HUNG / 1000} s.`);
			if (Date.now() - start > LONGEST_WORK)
				throw new Fault(`The page answers, but the action has not ended for ${LONGEST_WORK / 1000} s.`);
			await Promise.race([ended, delay(500, undefined, { ref: false })]);
		}
		return work;
	}
}
