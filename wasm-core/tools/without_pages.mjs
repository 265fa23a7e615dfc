/** Vite plugins that leave the pages' part of models out of bundles. */

/**
 * Dynamic imports of a model's index.ts: the studio's tools, and the renderer, which only pages and the element need.
 */
export const MODEL_UI = /^\.\/ui\/ui$/;
export const MODEL_RENDERER = /^\.\/render\/|_renderer$/;

/** Replaces imports of models by empty modules, so that a bundle has no scripts that nothing loads. */
export function without(...parts) {
	return {
		name: "without-pages",
		enforce: "pre",
		resolveId(source, importer) {
			const isLeftOut = /\/models\/.*\/index\.ts$/.test(importer ?? "") && parts.some((part) => part.test(source));
			return isLeftOut ? "\0empty" : undefined;
		},
		load: (id) => (id === "\0empty" ? "export {};" : undefined),
	};
}

/**
 * Removes the plugin by which Vite wraps every `import()` in a preload of styles. These bundles have no styles, Node
 * and workers have no document, and a reader's own Vite would wrap the imports again under the same name.
 */
export const withoutPreloading = {
	name: "without-preloading",
	configResolved({ plugins }) {
		const at = plugins.findIndex(({ name }) => name === "native:import-analysis-build");
		if (at < 0) throw new Error("Vite preloads in another way now; see wasm-core/tools/without_pages.mjs.");
		plugins.splice(at, 1);
	},
};
