/**
 * `npm run generate -- links [LINK…]`: adds links with the fingerprints of their plants to links.json, whose links are frozen. Without a link it adds
 * every link that has to be listed and is not. Listed links are never changed.
 */
import { argv } from "node:process";
import { fileURLToPath } from "node:url";
import { buildCore } from "../../../wasm-core/tools/core.mjs";
import { repository } from "../../../wasm-core/tools/repository.mjs";

/**
 * @param {readonly string[]} links where empty: all that have to be listed and are not
 * @returns {Promise<string[]>} the links that were added
 */
export async function addLinks(links = []) {
	await buildCore();
	const { createServer } = await import("vite");
	const server = await createServer({
		configFile: false,
		root: repository,
		appType: "custom",
		logLevel: "error",
		server: { middlewareMode: true, hmr: false, watch: null },
		optimizeDeps: { noDiscovery: true },
	});
	try {
		const module = await server.ssrLoadModule("/tests/golden/links/add_links.ts");
		return await module.addLinks(links);
	} finally {
		await server.close();
	}
}

if (argv[1] === fileURLToPath(import.meta.url)) {
	try {
		const added = await addLinks(argv.slice(2));
		for (const link of added) console.log(link);
		console.log(`${added.length} links added.`);
	} catch (error) {
		console.error(error instanceof Error ? error.message : error);
		process.exitCode = 1;
	}
}
