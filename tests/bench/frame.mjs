/**
 * Cost of drawing: CPU time of Chromium's GPU process, where SwiftShader draws, per full frame. This is the closest
 * measure to a small graphics card that is available on every machine; wall time would include other processes.
 */
import { join } from "node:path";
import { build, preview } from "vite";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { launch } from "../browsers/chromium.mjs";
import { printTable } from "./statistics.mjs";

const FRAMES = 3;
const ROUNDS = 4;
const SIZE = [1024, 640];
const BUNCHES = [
	["natural, long-conical", "?v=2&preset=long-conical"],
	["natural, pale (Shine Muscat)", "?v=2&preset=shine-muscat"],
	["the paper's, grape-15b", "?v=1&preset=grape-15b"],
	["stems only", "?v=2&preset=long-conical", "stems"],
];
const configFile = join(repository, "tests/views/vite.config.ts");

/** @param {string} [built] folder of a page of views built before; without it this tree's is built */
export async function benchFrame(built) {
	process.env.NODE_ENV = "production";
	if (!built) await build({ configFile, logLevel: "error" });
	const server = await preview({
		configFile,
		preview: { port: 0, host: "localhost" },
		logLevel: "error",
		...(built ? { build: { outDir: built } } : {}),
	});
	const browser = await launch();
	const rows = [["", "GPU process, s", "page's process, ms"]];
	try {
		const processes = await browser.newBrowserCDPSession();
		for (const [title, query, mode] of BUNCHES) {
			const page = await browser.newPage({ viewport: { width: SIZE[0], height: SIZE[1] } });
			await page.goto(server.resolvedUrls.local[0]);
			await page.waitForFunction(() => "views" in window);
			await page.evaluate(open, { query, mode, size: SIZE });
			const rounds = [];
			for (let round = 0; round < ROUNDS; round++) rounds.push(await costOf(processes, page));
			// Other load on the machine only increases the time.
			rows.push([title, least(rounds, "GPU").toFixed(2), (1000 * least(rounds, "renderer")).toFixed(1)]);
			await page.close();
		}
	} finally {
		await browser.close();
		await server.close();
	}
	printTable(`A full frame, ${SIZE.join(" × ")}, SwiftShader, the least of ${ROUNDS} rounds of ${FRAMES}`, rows);
}

const least = (rounds, key) => Math.min(...rounds.map((round) => round[key]));

/** Processor time of the GPU process and of the pages, seconds a frame. */
async function costOf(processes, page) {
	const before = await times(processes);
	await page.evaluate(redraw, FRAMES);
	const after = await times(processes);
	return { GPU: (after.GPU - before.GPU) / FRAMES, renderer: (after.renderer - before.renderer) / FRAMES };
}

async function times(processes) {
	const { processInfo } = await processes.send("SystemInfo.getProcessInfo");
	const sum = (type) => processInfo.reduce((all, each) => all + (each.type === type ? each.cpuTime : 0), 0);
	return { GPU: sum("GPU"), renderer: sum("renderer") };
}

/** In the page: shows a bunch and draws it once, so that programs and buffers are there. */
async function open({ query, mode, size }) {
	globalThis.viewer = globalThis.views.view(query, size, { checked: false });
	if (mode) globalThis.viewer.setMode(mode);
	await globalThis.viewer.whenIdle();
}

/** In the page: draws at full resolution again and again. */
async function redraw(frames) {
	for (let frame = 0; frame < frames; frame++) {
		globalThis.viewer.requestRender();
		await globalThis.viewer.whenIdle();
	}
}
