import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { core } from "./wasm-core/tools/vite_plugin.mjs";
import { MODEL_RENDERER, MODEL_UI, without } from "./wasm-core/tools/without_pages.mjs";
import { docsSite } from "./web/docs_site.mjs";
import { handsFiles } from "./web/hands_files.mjs";
import { leanThree } from "./web/lean_three.mjs";
import { offlineApp } from "./web/offline_app.mjs";

const at = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
	root: at("web"),
	publicDir: at("public"),
	// Use relative addresses, so that dist/ works from any path.
	base: "./",
	plugins: [core(), leanThree(), offlineApp(), handsFiles(), docsSite()],
	// Workers draw nothing: without the pages' part of models, their bundles have no second copy of it.
	worker: { format: "es", plugins: () => [without(MODEL_UI, MODEL_RENDERER)] },
	build: {
		outDir: at("dist"),
		emptyOutDir: true,
		target: "es2022",
		// Inline nothing: the pages' content security policy forbids inline scripts and data: addresses of modules.
		assetsInlineLimit: 0,
		modulePreload: { polyfill: false },
		rolldownOptions: {
			input: {
				index: at("web/index.html"),
				embed: at("web/embed.html"),
				panicle: at("web/src/element/panicle.ts"),
				specimens: at("web/src/offline/ready.ts"),
			},
			preserveEntrySignatures: "exports-only",
			output: {
				// Other pages refer to these scripts: their names are stable.
				entryFileNames: ({ name }) =>
					["panicle", "specimens"].includes(name) ? "[name].js" : "assets/[name]-[hash].js",
				advancedChunks: {
					// Group modules that are loaded together: several small scripts compress less well.
					groups: [
						{ name: "document", test: /web\/src\/(specimen\/|ui\/(change|handles\/(point|escape_key))\.ts)/ },
						{
							name: "lit",
							test: /node_modules\/(@lit|lit|lit-element|lit-html)\/|web\/src\/ui\/(term|icons|editor_element)\.ts/,
						},
						{ name: "three", test: /node_modules\/three\// },
					],
				},
			},
		},
	},
	server: { fs: { allow: [at(".")] } },
});
