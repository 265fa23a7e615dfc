/**
 * What drawing costs: processor time of Chromium's GPU process, where SwiftShader draws, to one full frame. The nearest
 * thing to a small graphics card that every machine has; wall time would count whatever else is running.
 */
import { join } from "node:path";
import { build, preview } from "vite";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { launch } from "../e2e/browser.mjs";
import { printTable } from "./statistics.mjs";

const FRAMES = 8;
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
	const rows = [["", "GPU process, s a frame", "page's process, ms a frame", "the same turned", "page's, ms"]];
	try {
		const processes = await browser.newBrowserCDPSession();
		for (const [title, query, mode] of BUNCHES) {
			const page = await browser.newPage({ viewport: { width: SIZE[0], height: SIZE[1] } });
			await page.goto(server.resolvedUrls.local[0]);
			await page.waitForFunction(() => "views" in window);
			await page.evaluate(open, { query, mode, size: SIZE });
			const still = await costOf(processes, () => page.evaluate(redraw, { frames: FRAMES, turn: 0 }));
			const turned = await costOf(processes, () => page.evaluate(redraw, { frames: FRAMES, turn: 0.05 }));
			rows.push([title, ...still, ...turned]);
			await page.close();
		}
	} finally {
		await browser.close();
		await server.close();
	}
	printTable(`A full frame, ${SIZE.join(" × ")}, SwiftShader, means of ${FRAMES}`, rows);
}

/** Processor time of the GPU process in seconds and of the pages in milliseconds, to a frame. */
async function costOf(processes, draw) {
	const before = await times(processes);
	await draw();
	const after = await times(processes);
	return [
		((after.GPU - before.GPU) / FRAMES).toFixed(2),
		((1000 * (after.renderer - before.renderer)) / FRAMES).toFixed(1),
	];
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

/** In the page: draws at full resolution again and again, the camera turned by so much between. */
async function redraw({ frames, turn }) {
	const { viewer } = globalThis;
	for (let frame = 0; frame < frames; frame++) {
		const { position } = viewer.camera;
		// Not `orbit`, whose frames may be coarser.
		const [x, z] = [position.x, position.z];
		position.x = Math.cos(turn) * x + Math.sin(turn) * z;
		position.z = Math.cos(turn) * z - Math.sin(turn) * x;
		viewer.camera.lookAt(0, position.y, 0);
		viewer.requestRender();
		await viewer.whenIdle();
	}
}
