/**
 * `npm run generate -- leaves`: grows the leaves of other plants with the leaf model, and writes them as
 * web/src/plant/leaves/*.json. Run it when the leaf model or one of these presets has changed, and commit the files.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { buildCore } from "../core.mjs";
import { buildFolder, repository } from "../repository.mjs";
import { setUp } from "../setup.mjs";

/** Builds the core, and grows the leaves by the page's own modules, which Vite loads. */
export async function generateLeaves() {
	await setUp("core");
	await buildCore();
	const { createServer } = await import("vite");
	const server = await createServer({
		root: repository,
		configFile: false,
		logLevel: "error",
		server: { middlewareMode: true, ws: false },
		optimizeDeps: { noDiscovery: true },
	});
	try {
		const at = (path) => server.ssrLoadModule(`/web/src/${path}`);
		const { loadCoreFromBytes } = await at("core/loader.ts");
		const { BAKED_LEAVES, bakeLeaf } = await at("models/leaf/attached/bake.ts");
		const core = await loadCoreFromBytes(readFileSync(join(buildFolder, "core/particles.wasm")));
		for (const name of BAKED_LEAVES) {
			const text = `${JSON.stringify(bakeLeaf(core, name), null, "\t")}\n`;
			writeFileSync(join(repository, `web/src/plant/leaves/${name}.json`), text);
			console.log(`web/src/plant/leaves/${name}.json: ${(gzipSync(text).length / 1000).toFixed(1)} kB gzipped`);
		}
	} finally {
		await server.close();
	}
}
