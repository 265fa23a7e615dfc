/** Every preset grown and drawn by the app's own core and scene, for the scripts that keep pictures of them. */
import { createServer } from "vite";
import { launch } from "./browser.mjs";

const core = `/@fs${new URL("../../build/core/bunch.wasm", import.meta.url).pathname}`;

/**
 * @typedef {object} Asked
 * @property {{ width: number, height: number }} size of a picture, pixels
 * @property {number} oversampling drawn this much larger and scaled down: softer edges than the canvas's own
 * @property {number} quality of the WebP, 0 … 1
 * @property {"light" | "dark"} theme
 * @property {("three-quarter" | "front" | "side")[]} views
 */

/** Runs in the page, where Vite serves the sources. */
async function draw({ address, name, size, oversampling, quality, theme, views }) {
	const at = (path) => import(/* @vite-ignore */ `/src/${path}`);
	const { Viewer } = await at("scene/viewer.ts");
	const { bunchFigure } = await at("models/bunch/figure/bunch_figure.ts");
	const { Core } = await at("core/core.ts");
	const { compileCore } = await at("core/loader.ts");
	const { encodeRequest } = await at("models/bunch/request.ts");
	const { readGrown } = await at("models/bunch/read_grown.ts");
	const { specimenFromPreset } = await at("models/bunch/species.ts");
	const { MEASURE_KEYS } = await at("models/bunch/measures.generated.ts");
	globalThis.core ??= await Core.instantiate(await compileCore(address));
	const specimen = specimenFromPreset(name);
	const grown = readGrown(globalThis.core.grow(encodeRequest(specimen)));
	const [width, height] = [size.width * oversampling, size.height * oversampling];
	// One view for all: building its programs takes longer than drawing.
	if (!globalThis.view) {
		const canvas = Object.assign(document.createElement("canvas"), { width, height });
		globalThis.view = new Viewer(canvas, { still: true, reducedMotion: true, theme });
		globalThis.view.use(bunchFigure);
	}
	globalThis.view.show(grown, specimen);
	const pictures = {};
	for (const view of views) {
		globalThis.view.resetView(view);
		const image = await createImageBitmap(await globalThis.view.snapshot(width, height));
		const small = new OffscreenCanvas(size.width, size.height);
		const context = small.getContext("2d");
		context.imageSmoothingQuality = "high";
		context.drawImage(image, 0, 0, size.width, size.height);
		const blob = await small.convertToBlob({ type: "image/webp", quality });
		const bytes = new Uint8Array(await blob.arrayBuffer());
		pictures[view] = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
	}
	const measures = Object.fromEntries(MEASURE_KEYS.map((key, index) => [key, grown.measures?.[index] ?? Number.NaN]));
	return { pictures, measures };
}

async function listPresets() {
	const { PRESETS } = await import(/* @vite-ignore */ "/src/models/bunch/presets/presets.ts");
	return PRESETS.map(({ name, title, kind, figure, about }) => ({ name, title, kind, figure, about }));
}

/**
 * Draws every preset, in the order of the gallery.
 * @param {Asked[]} asked one after the other
 * @param {(preset: object, drawn: { pictures: Record<string, Buffer>, measures: Record<string, number> }, asked: Asked) => void} keep
 */
export async function drawPresets(asked, keep) {
	// Nothing may load the page anew while it draws: no watching, no bundling of packages behind its back.
	const server = await createServer({
		server: { host: "localhost", port: 0, hmr: false, watch: null },
		optimizeDeps: { noDiscovery: true, include: [] },
		logLevel: "warn",
	});
	await server.listen();
	const browser = await launch();
	for (const each of asked) {
		const page = await browser.newPage({ viewport: { width: 600, height: 600 } });
		await page.goto(server.resolvedUrls.local[0]);
		for (const preset of await page.evaluate(listPresets)) {
			const { pictures, measures } = await page.evaluate(draw, { address: core, name: preset.name, ...each });
			const decoded = Object.entries(pictures).map(([view, base64]) => [view, Buffer.from(base64, "base64")]);
			keep(preset, { pictures: Object.fromEntries(decoded), measures }, each);
		}
		await page.close();
	}
	await browser.close();
	await server.close();
}
