/**
 * A stand of 2,000 trees: the time of its plants in wasm, and in the built page the cost of a view with drawing
 * switched off (calls and triangles are counted) and the memory.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { createServer, preview } from "vite";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { launch } from "../browsers/chromium.mjs";
import { benchBeds } from "./beds.mjs";
import { median, printTable } from "./statistics.mjs";

const PRESETS = ["ecosystem-500", "ecosystem-1000", "ecosystem-2000"];
const FRAMES = 40;
const MEGABYTE = 1e6;

export async function benchStand() {
	// Later fetches of modules go to the same server.
	let memories;
	const server = await createServer({
		configFile: join(repository, "vite.config.ts"),
		server: { middlewareMode: true, watch: null },
		optimizeDeps: { noDiscovery: true, include: [] },
		logLevel: "warn",
	});
	try {
		const source = (path) => server.ssrLoadModule(join(repository, path));
		await benchBeds(source);
		memories = await benchCores(source);
	} finally {
		await server.close();
	}
	await benchViews(memories);
}

/** Milliseconds of wasm time a tree, all of its levels' meshes included. @returns bytes that the cores of one worker take, by preset */
async function benchCores(source) {
	const { loadCoreFromBytes } = await source("web/src/core/loader.ts");
	const loadCore = (wasm) => loadCoreFromBytes(readFileSync(join(repository, "build/core", wasm)));
	const { model } = await source("web/src/models/stand/index.ts");
	const { growPlant } = await source("web/src/generate/growth.ts");
	const { fromPreset } = await source("web/src/specimen/from_preset.ts");
	const rows = [];
	const memories = new Map();
	for (const preset of PRESETS) {
		const cores = new Map();
		const times = [];
		let plan = 0;
		const run = async (wasm, blocks) => {
			const core = cores.get(wasm) ?? (await loadCore(wasm));
			cores.set(wasm, core);
			const answer = core.grow(blocks);
			if (wasm === model.wasm) plan = answer.milliseconds;
			else times.push(answer.milliseconds);
			return answer;
		};
		const start = performance.now();
		await growPlant(model, fromPreset(model, preset), {}, run);
		const whole = performance.now() - start;
		const memory = [...cores.values()].reduce((sum, core) => sum + core.memoryBytes, 0);
		memories.set(preset, memory);
		const mean = times.reduce((sum, time) => sum + time, 0) / times.length;
		rows.push([
			preset,
			plan.toFixed(1),
			times.length,
			mean.toFixed(2),
			median(times).toFixed(2),
			(whole / 1000).toFixed(1),
			(memory / MEGABYTE).toFixed(0),
		]);
	}
	printTable("stand: wasm, one thread", [
		["", "plan, ms", "trees", "mean, ms", "median, ms", "all, s", "wasm memory, MB"],
		...rows,
	]);
	return memories;
}

/** Runs in the page before its own scripts: counts WebGL calls, and times the script's part of frames. */
function counting() {
	const counts = { calls: 0, triangles: 0, buffers: 0, frames: [] };
	window.standBench = counts;
	const gl = WebGL2RenderingContext.prototype;
	const count = (indices, times = 1) => {
		counts.calls++;
		counts.triangles += (indices * times) / 3;
	};
	gl.drawElements = (_, indices) => count(indices);
	gl.drawArrays = (_, __, indices) => count(indices);
	gl.drawElementsInstanced = (_, indices, __, ___, times) => count(indices, times);
	gl.drawArraysInstanced = (_, __, indices, times) => count(indices, times);
	gl.drawRangeElements = (_, __, ___, indices) => count(indices);
	const { getExtension, bufferData } = gl;
	gl.getExtension = function (name) {
		const found = getExtension.call(this, name);
		if (name !== "WEBGL_multi_draw" || !found) return found;
		return {
			multiDrawElementsWEBGL: (_, sizes, from, __, ___, ____, many) => {
				let sum = 0;
				for (let i = 0; i < many; i++) sum += sizes[from + i];
				count(sum);
			},
			multiDrawArraysWEBGL: () => count(0),
			multiDrawElementsInstancedWEBGL: (_, sizes, from, __, ___, ____, times, at, many) => {
				let sum = 0;
				for (let i = 0; i < many; i++) sum += sizes[from + i] * times[at + i];
				count(sum);
			},
			multiDrawArraysInstancedWEBGL: () => count(0),
		};
	};
	gl.bufferData = function (target, data, ...rest) {
		counts.buffers += typeof data === "number" ? data : (data?.byteLength ?? 0);
		return bufferData.call(this, target, data, ...rest);
	};
	const { requestAnimationFrame } = window;
	window.requestAnimationFrame = (callback) =>
		requestAnimationFrame((now) => {
			const [start, calls, triangles] = [performance.now(), counts.calls, counts.triangles];
			callback(now);
			if (counts.calls > calls)
				counts.frames.push([performance.now() - start, counts.calls - calls, counts.triangles - triangles]);
		});
}

async function benchViews(memories) {
	const server = await preview({
		configFile: join(repository, "vite.config.ts"),
		preview: { port: 0, host: "localhost" },
		logLevel: "warn",
	});
	const browser = await launch();
	try {
		const rows = [];
		for (const preset of PRESETS)
			rows.push(
				await viewOf(
					browser,
					`${server.resolvedUrls.local[0]}?v=2&model=stand&preset=${preset}`,
					preset,
					memories.get(preset),
				),
			);
		printTable("stand: the page, drawing switched off", [
			[
				"",
				"grown, s",
				"calls",
				"triangles",
				"script a frame, ms",
				"buffers, MB",
				"heap, MB",
				"workers",
				"all with wasm, MB",
			],
			...rows,
		]);
	} finally {
		await browser.close();
		await server.close();
	}
}

async function viewOf(browser, address, preset, wasm) {
	const page = await browser.newPage({ viewport: { width: 1024, height: 640 } });
	await page.addInitScript(counting);
	const start = Date.now();
	await page.goto(address);
	const words = page.getByText(/plants of \d+ kinds on [^,]*$/).first();
	await words.waitFor({ timeout: 300_000 });
	const grown = (Date.now() - start) / 1000;
	await page.locator("canvas").first().focus();
	await page.waitForTimeout(500);
	await page.evaluate(() => {
		window.standBench.frames.length = 0;
	});
	for (let i = 0; i < FRAMES; i++) await page.keyboard.press("ArrowLeft");
	await page.getByRole("button", { name: "Walk through" }).click();
	for (let i = 0; i < FRAMES; i++) await page.getByRole("button", { name: "Walk forwards" }).click();
	const { frames, buffers } = await page.evaluate(() => window.standBench);
	// Those that are needed no more end after a rest; the spare has grown nothing.
	await page.waitForTimeout(6000);
	const workers = page.workers().length;
	const client = await page.context().newCDPSession(page);
	await client.send("HeapProfiler.collectGarbage");
	const { usedSize } = await client.send("Runtime.getHeapUsage");
	const { backingStorageSize = 0 } = await client.send("Runtime.getHeapUsage");
	await page.close();
	const all = buffers + usedSize + backingStorageSize + workers * wasm;
	const most = (k) => Math.max(...frames.map((frame) => frame[k]));
	return [
		preset,
		grown.toFixed(1),
		most(1),
		Math.round(most(2)).toLocaleString("en"),
		median(frames.map(([time]) => time)).toFixed(2),
		(buffers / MEGABYTE).toFixed(0),
		((usedSize + backingStorageSize) / MEGABYTE).toFixed(0),
		workers,
		(all / MEGABYTE).toFixed(0),
	];
}
