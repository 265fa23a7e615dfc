/**
 * Costs of the built page in the system's Chromium: its first load, and a drag until new buffers arrive, which the
 * studio measures as "regrow". SwiftShader draws here, whose frames take far longer than a graphics card's.
 */
import { join } from "node:path";
import { build, preview } from "vite";
import { modulesFolder, repository } from "../../wasm-core/tools/repository.mjs";
import { launch } from "../browsers/chromium.mjs";
import { byKind, firstLoad, gzipped } from "./sizes.mjs";
import { median, printTable } from "./statistics.mjs";

const LOADS = 5;
const DRAG_STEPS = 60;
const FRAME = 1000 / 60;
const dist = join(repository, "dist");
const viewport = { width: 1024, height: 640 };

export async function benchBrowser() {
	// Importing the app's modules has declared this a development process, which the build would believe.
	process.env.NODE_ENV = "production";
	await build({ root: join(repository, "web"), configFile: join(repository, "vite.config.ts"), logLevel: "warn" });
	const server = await preview({
		configFile: join(repository, "vite.config.ts"),
		preview: { port: 0, host: "localhost" },
		logLevel: "warn",
	});
	const browser = await launch();
	try {
		const address = server.resolvedUrls.local[0];
		benchSizes(await benchLoad(browser, address));
		await benchDrag("natural, long-conical", `${address}?v=2&preset=long-conical`);
		await benchDrag("natural, 500 berries", `${address}?v=2&preset=long-conical&count=500&size=11`);
		await benchDrag("the paper's, winged-cylindrical", `${address}?v=1&preset=winged-cylindrical`);
	} finally {
		await browser.close();
		await server.close();
	}
}

/** Times warm loads; returns the paths that the first load requested. */
async function benchLoad(browser, address) {
	// Prefetching for the cache must not run during the measurement.
	const context = await browser.newContext({ viewport, serviceWorkers: "block" });
	const requested = new Set();
	const marks = [];
	const frames = [];
	for (let load = 0; load <= LOADS; load++) {
		const page = await context.newPage();
		await page.goto(address);
		await page.waitForFunction(() => performance.getEntriesByName("first-bunch").length > 0);
		const drawn = await page.evaluate(
			() =>
				new Promise((resolve) => {
					const mark = performance.getEntriesByName("first-bunch")[0].startTime;
					requestAnimationFrame(() => requestAnimationFrame(() => resolve({ mark, frame: performance.now() })));
				}),
		);
		if (load === 0) for (const path of await page.evaluate(requestedPaths)) requested.add(path);
		if (load > 0) {
			marks.push(drawn.mark);
			frames.push(drawn.frame);
		}
		await page.close();
	}
	await context.close();
	printTable(`First load, warm, 1024 × 640, SwiftShader, medians of ${LOADS} (aims 1000 and 2000 ms)`, [
		["", "ms"],
		["first draw submitted (mark first-bunch)", median(marks).toFixed(0)],
		["first frame done", median(frames).toFixed(0)],
	]);
	return [...requested].map((path) => path || "index.html");
}

/** Runs in the page: paths requested before the first plant was drawn. */
function requestedPaths() {
	const [{ startTime: first }] = performance.getEntriesByName("first-bunch");
	const before = performance.getEntriesByType("resource").filter(({ startTime }) => startTime <= first);
	return ["", ...before.map(({ name }) => new URL(name).pathname.slice(1))];
}

function benchSizes(requested) {
	const files = firstLoad(dist, requested);
	const kinds = byKind(files);
	const kilobytes = (bytes) => (bytes / 1000).toFixed(1);
	printTable("Size, gzipped, kB (aims: core 100, first load 400)", [
		["file", "kB"],
		["core, bunch.wasm", kilobytes(gzipped(join(modulesFolder, "bunch.wasm")))],
		...files.filter(({ bytes }) => bytes > 500).map(({ path, bytes }) => [`  ${path}`, kilobytes(bytes)]),
		["first load: page, styles, scripts, core", kilobytes(kinds.code + kinds.core)],
		["  fonts", kilobytes(kinds.fonts)],
		["  the gallery's pictures in view", kilobytes(kinds.pictures)],
	]);
}

/**
 * Drags p3 of the front view in a page without WebGL: the 3-D view is off, because SwiftShader's frames would dominate
 * the time. (Chromium keeps WebGL under --disable-gpu, which only disables compositing.) Each regrowth is timed from
 * two starts: from the request to the worker, and from the newest pointer event before that, which waits for the frame
 * that is being drawn.
 */
async function benchDrag(bunch, address) {
	const browser = await launch(["--disable-gpu"]);
	const page = await browser.newPage({ viewport, serviceWorkers: "block" });
	await page.addInitScript(withholdWebgl);
	await page.goto(address);
	await page.waitForFunction(() => performance.getEntriesByName("regrow").length > 0);
	await page
		.getByText(/no WebGL 2/)
		.first()
		.waitFor();
	const handle = page.getByRole("button", { name: /^p3, right/ }).first();
	const box = await handle.boundingBox();
	const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
	await page.mouse.move(x, y);
	await page.mouse.down();
	await page.evaluate(noteRegrowths);
	for (let step = 1; step <= DRAG_STEPS; step++) {
		await page.mouse.move(x - 20 * Math.sin(step / 8), y + 10 * Math.cos(step / 5));
		await page.waitForTimeout(FRAME);
	}
	await page.waitForTimeout(500);
	const regrowths = await page.evaluate(() => window.regrowths);
	await browser.close();
	printTable(`Drag before drawing, ${bunch}, ${regrowths.length} regrowths (aim: within ${FRAME.toFixed(1)} ms)`, [
		["ms", "median", "95th percentile", "within one 60 Hz frame"],
		["request → buffers", ...spread(regrowths.map(({ request }) => request))],
		["event → buffers", ...spread(regrowths.map(({ event }) => event))],
	]);
}

/** In the page: no canvas has WebGL. */
function withholdWebgl() {
	for (const kind of [HTMLCanvasElement, OffscreenCanvas]) {
		const { getContext } = kind.prototype;
		kind.prototype.getContext = function (name, ...rest) {
			return /^(experimental-)?webgl/.test(name) ? null : getContext.call(this, name, ...rest);
		};
	}
}

/** In the page: keeps how long each regrowth took, in milliseconds up to the arrival of its buffers. */
function noteRegrowths() {
	const moves = [];
	window.regrowths = [];
	window.addEventListener(
		"pointermove",
		({ timeStamp }) => moves.push({ happened: timeStamp, seen: performance.now() }),
		{ capture: true },
	);
	new PerformanceObserver((list) => {
		for (const { startTime, duration } of list.getEntriesByName("regrow")) {
			const move = moves.findLast(({ seen }) => seen <= startTime);
			if (move) window.regrowths.push({ request: duration, event: startTime + duration - move.happened });
		}
	}).observe({ entryTypes: ["measure"] });
}

/** Median, 95th percentile, and how many stay within a frame. */
function spread(times) {
	const sorted = [...times].sort((a, b) => a - b);
	const within = times.filter((time) => time <= FRAME).length;
	return [
		median(times).toFixed(1),
		sorted[Math.floor(sorted.length * 0.95)].toFixed(1),
		`${within} of ${times.length}`,
	];
}
