/**
 * `npm run bench -- watching [model/preset …]`: work of the page's thread while particles move, from the first frame
 * of a play to the plant at rest. Drawing is switched off in the page (WebGL's draws do nothing, all calls to them
 * stay), because software drawing would dominate. CPU time of the thread counts, task by task; of several plays the
 * least, since other load only increases the time.
 */
import { join } from "node:path";
import { build, preview } from "vite";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { launch } from "../browsers/chromium.mjs";
import { withoutDrawing } from "../e2e/without_drawing.mjs";
import { printTable } from "./statistics.mjs";
import { heaviestIn, tasksOf } from "./trace.mjs";

const PLANTS = ["leaf/grapevine", "tree/oak", "root/tap"];
const PLAYS = 4;
/** A frame of a screen of 60 Hz. */
const AIM = 16;
/** Time after the end of a play in which related work may follow, milliseconds. */
const AFTER = 2500;
const PAUSED = "the life has come to its end";
const folder = join(repository, "build/bench/watching");
const configFile = join(repository, "vite.config.ts");

/** @param {string[]} plants as `tree/oak` */
export async function benchWatching(plants) {
	process.env.NODE_ENV = "production";
	// As it is published, but that functions keep their names.
	const own = { outDir: folder, minify: false };
	await build({ root: join(repository, "web"), configFile, build: own, logLevel: "error" });
	const server = await preview({
		configFile,
		preview: { port: 0, host: "localhost" },
		build: { outDir: folder },
		logLevel: "error",
	});
	const browser = await launch();
	const rows = [
		["", "tasks", `over ${AIM} ms`, "worst, ms", "99th percentile", "first play", "what the worst one did"],
	];
	try {
		for (const plant of plants.length > 0 ? plants : PLANTS) {
			rows.push(await benchPlant(browser, server.resolvedUrls.local[0], plant));
		}
	} finally {
		await browser.close();
		await server.close();
	}
	printTable(
		`Watching particles run: tasks of the page's thread, the least of ${PLAYS} plays (aim: none over ${AIM} ms)`,
		rows,
	);
}

/** A page with a plant at rest. */
export async function openPlant(browser, address, plant) {
	const [model, preset] = plant.split("/");
	const page = await browser.newPage({ viewport: { width: 1024, height: 640 }, serviceWorkers: "block" });
	await page.addInitScript(withoutDrawing);
	await page.addInitScript(logWhenPaused, PAUSED);
	await page.goto(`${address}?v=2&model=${model}&preset=${preset}`);
	await page.waitForFunction(() => document.querySelector(".play") && document.querySelector("[data-fingerprint]"));
	await page.waitForTimeout(AFTER);
	return page;
}

async function benchPlant(browser, address, plant) {
	const page = await openPlant(browser, address, plant);
	const plays = [];
	for (let i = 0; i < PLAYS; i++) plays.push(tasksOf(await traced(browser, page)));
	const [named] = tasksOf(await traced(browser, page, ["disabled-by-default-v8.cpu_profiler"]));
	await page.close();
	const worst = plays.map(([task]) => task.milliseconds);
	const best = plays[worst.indexOf(Math.min(...worst))];
	return [
		plant,
		best.length,
		Math.min(...plays.map((tasks) => tasks.filter(({ milliseconds }) => milliseconds > AIM).length)),
		Math.min(...worst).toFixed(1),
		Math.min(...plays.map(percentile)).toFixed(1),
		worst[0].toFixed(1),
		heaviestIn(named),
	];
}

/** Of tasks worth the name, a millisecond or longer; the longest is first. */
function percentile(tasks) {
	const worth = tasks.filter(({ milliseconds }) => milliseconds >= 1);
	return worth[Math.floor(0.01 * worth.length)]?.milliseconds ?? 0;
}

/** Plays an animation from its beginning and returns the trace. */
export async function traced(browser, page, more = []) {
	await browser.startTracing(page, { categories: ["toplevel", "devtools.timeline", "v8", ...more] });
	const ended = page.waitForEvent("console", { predicate: (message) => message.text() === PAUSED, timeout: 300_000 });
	await page.keyboard.press("k");
	await ended;
	await page.waitForTimeout(AFTER);
	return JSON.parse((await browser.stopTracing()).toString()).traceEvents;
}

/** Runs in the page: logs the end of an animation. Polling would cause work in the page. */
function logWhenPaused(words) {
	let button = null;
	new MutationObserver((_, watch) => {
		button = document.querySelector(".play");
		if (!button) return;
		watch.disconnect();
		const logPaused = () => button.ariaLabel === "Play" && console.log(words);
		new MutationObserver(logPaused).observe(button, { attributeFilter: ["aria-label"] });
	}).observe(document, { childList: true, subtree: true });
}
