/** Programs of web/src, bundled for Node. */
import { join } from "node:path";
import { repository } from "./repository.mjs";

/**
 * Bundles scripts of web/src as ES modules for Node into a folder.
 * @param {Record<string, string>} entries paths in web/src by the names of the scripts they become, without `.mjs`
 * @param {string} folder is emptied before
 * @param {{ alone?: boolean }} options alone: one file that needs no other, packages and cores in it
 */
export async function bundleForNode(entries, folder, { alone = false } = {}) {
	const { build } = await import("vite");
	const input = Object.fromEntries(
		Object.entries(entries).map(([name, path]) => [name, join(repository, "web/src", path)]),
	);
	await build({
		root: repository,
		configFile: false,
		publicDir: false,
		logLevel: "silent",
		...(alone ? { ssr: { noExternal: true }, assetsInclude: ["**/*.wasm"] } : {}),
		build: {
			ssr: true,
			outDir: folder,
			emptyOutDir: true,
			target: "node20",
			rolldownOptions: {
				input,
				output: { entryFileNames: "[name].mjs", ...(alone ? { codeSplitting: false } : {}) },
			},
		},
	});
}
