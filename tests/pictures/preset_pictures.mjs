/** Presets grown and drawn by the app's own core and scene, for the scripts that keep pictures of them. */
import { modulesFolder } from "../../wasm-core/tools/repository.mjs";
import { openSources } from "./sources_page.mjs";

/**
 * @typedef {object} PictureOptions
 * @property {{ width: number, height: number }} size of a picture, pixels
 * @property {number} oversampling drawn this much larger and scaled down: softer edges than the canvas's own
 * @property {number} quality of the WebP, 0 … 1
 * @property {"light" | "dark"} theme
 * @property {("three-quarter" | "front" | "side")[]} views
 * @property {(preset: { name: string }) => number | undefined} [zoom] how many times as large as it is in the whole view
 */

/** Runs in the page, where Vite serves the sources. */
async function draw({ cores, model: called, name, size, oversampling, quality, theme, views, zoom = 1 }) {
	const at = (path) => import(/* @vite-ignore */ `/src/${path}`);
	const { Viewer } = await at("render/viewer.ts");
	const { partRenderer } = await at("render/part_renderer.ts");
	const { Core } = await at("core/core.ts");
	const { compileCore } = await at("core/loader.ts");
	const { fromPreset } = await at("specimen/from_preset.ts");
	const { modelNamed } = await at("models/index.ts");
	const { growPlant } = await at("generate/growth.ts");
	const model = await modelNamed(called);
	const specimen = fromPreset(model, name);
	globalThis.cores ??= new Map();
	const coreOf = async (wasm) => Core.instantiate(await compileCore(`/@fs${cores}/${wasm}`));
	const grown = await growPlant(model, specimen, {}, async (wasm, blocks) => {
		if (!globalThis.cores.has(wasm)) globalThis.cores.set(wasm, await coreOf(wasm));
		return globalThis.cores.get(wasm).grow(blocks);
	});
	const [width, height] = [size.width * oversampling, size.height * oversampling];
	// One view for all: building its programs takes longer than drawing.
	if (!globalThis.view) {
		const canvas = Object.assign(document.createElement("canvas"), { width, height });
		globalThis.view = new Viewer(canvas, { still: true, reducedMotion: true, theme });
		globalThis.view.use((await model.render?.()) ?? partRenderer((plant, from) => model.parts(plant, from)));
	}
	globalThis.view.show(grown, specimen);
	const pictures = {};
	for (const view of views) {
		globalThis.view.resetView(view);
		globalThis.view.zoom(zoom);
		const image = await createImageBitmap(await globalThis.view.snapshot(width, height));
		const small = new OffscreenCanvas(size.width, size.height);
		const context = small.getContext("2d");
		context.imageSmoothingQuality = "high";
		context.drawImage(image, 0, 0, size.width, size.height);
		const blob = await small.convertToBlob({ type: "image/webp", quality });
		const bytes = new Uint8Array(await blob.arrayBuffer());
		pictures[view] = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
	}
	const measures = Object.fromEntries(
		model.table.measures.map(({ key }, index) => [key, grown.measures?.[index] ?? Number.NaN]),
	);
	return { pictures, measures };
}

async function listPresets(model) {
	const { modelNamed } = await import(/* @vite-ignore */ "/src/models/index.ts");
	const { presets } = await modelNamed(model);
	return presets.list.map(({ name, title, kind, figure, about }) => ({ name, title, kind, figure, about }));
}

/**
 * Draws every preset of a model, in the order of the gallery.
 * @param {string} model its name
 * @param {PictureOptions[]} options one after the other
 * @param {(preset: object, drawn: { pictures: Record<string, Buffer>, measures: Record<string, number> }, options: PictureOptions) => void} keep
 * @param {(preset: { name: string }) => boolean} wanted
 */
export async function drawPresets(model, options, keep, wanted = () => true) {
	const sources = await openSources();
	for (const each of options) {
		const page = await sources.page();
		for (const preset of await page.evaluate(listPresets, model)) {
			if (!wanted(preset)) continue;
			const { pictures, measures } = await page.evaluate(draw, {
				cores: modulesFolder,
				model,
				name: preset.name,
				...each,
				zoom: each.zoom?.(preset),
			});
			const decoded = Object.entries(pictures).map(([view, base64]) => [view, Buffer.from(base64, "base64")]);
			keep(preset, { pictures: Object.fromEntries(decoded), measures }, each);
		}
		await page.close();
	}
	await sources.close();
}
