/**
 * `npm run gallery`: renders every preset in both themes with the app's own scene, as public/gallery/*.webp. Run it when
 * a preset or the scene's light has changed, and commit what it writes.
 */
import { mkdirSync, writeFileSync } from "node:fs";
import { createServer } from "vite";
import { launch } from "./browser.mjs";

/** Twice the size they are shown at, for dense screens. */
const SIZE = { width: 120, height: 150 };
/** Drawn larger and scaled down: softer edges than the canvas's own. */
const OVERSAMPLING = 4;
const QUALITY = 0.86;
const folder = new URL("../../public/gallery/", import.meta.url);
const core = `/@fs${new URL("../../build/core/panicle.wasm", import.meta.url).pathname}`;

/** Runs in the page, where Vite serves the sources: grows every preset and draws it. */
async function draw({ core: address, size, oversampling, quality, theme }) {
	const at = (path) => import(/* @vite-ignore */ `/src/${path}`);
	const { renderPicture } = await at("scene/picture.ts");
	const { Core } = await at("core/core.ts");
	const { compileCore } = await at("core/loader.ts");
	const { encodeRequest } = await at("core/request.ts");
	const { specimenFromPreset } = await at("specimen/from_preset.ts");
	const { PRESETS } = await at("specimen/presets/index.ts");
	const core = await Core.instantiate(await compileCore(address));
	const large = { width: size.width * oversampling, height: size.height * oversampling, theme };
	const pictures = {};
	for (const { name } of PRESETS) {
		const specimen = specimenFromPreset(name);
		const grown = core.grow(encodeRequest(specimen));
		const image = await createImageBitmap(await renderPicture(grown, specimen.look, large));
		const small = new OffscreenCanvas(size.width, size.height);
		const context = small.getContext("2d");
		context.imageSmoothingQuality = "high";
		context.drawImage(image, 0, 0, size.width, size.height);
		const blob = await small.convertToBlob({ type: "image/webp", quality });
		const bytes = new Uint8Array(await blob.arrayBuffer());
		pictures[name] = btoa(String.fromCharCode(...bytes));
	}
	return pictures;
}

/** Nothing may load the page anew while it draws: no watching, no bundling of packages behind its back. */
const server = await createServer({
	server: { host: "localhost", port: 0, hmr: false, watch: null },
	optimizeDeps: { noDiscovery: true, include: [] },
	logLevel: "warn",
});
await server.listen();
const browser = await launch();
mkdirSync(folder, { recursive: true });
let total = 0;
for (const theme of ["light", "dark"]) {
	const page = await browser.newPage({ viewport: { width: 600, height: 600 } });
	await page.goto(server.resolvedUrls.local[0]);
	const pictures = await page.evaluate(draw, { core, size: SIZE, oversampling: OVERSAMPLING, quality: QUALITY, theme });
	for (const [name, base64] of Object.entries(pictures)) {
		const bytes = Buffer.from(base64, "base64");
		total += bytes.length;
		writeFileSync(new URL(`${name}-${theme}.webp`, folder), bytes);
	}
	await page.close();
}
await browser.close();
await server.close();
console.log(`public/gallery: ${(total / 1024).toFixed(0)} kB in all`);
