/** Bundles of models without what only pages need of them. */

/** What models have of the page: the studio's tools, and what draws them, which is the element's alone. */
export const FACE = /\.\/tools\/face$/;
export const FIGURE = /^\.\/figure\/|_figure$/;

/** Leaves out of models' folders what no entry of a bundle comes to: it would lie about as scripts that nobody loads. */
export function without(...parts) {
	return {
		name: "without-pages",
		enforce: "pre",
		resolveId(source, importer) {
			const left = /\/models\/.*\/index\.ts$/.test(importer ?? "") && parts.some((part) => part.test(source));
			return left ? "\0nothing" : undefined;
		},
		load: (id) => (id === "\0nothing" ? "export {};" : undefined),
	};
}

/**
 * Vite wraps every `import()` in what preloads styles. Here are none, Node and workers have no document, and a bundler that is Vite too
 * would wrap them again under the same name: its plugin for that goes.
 */
export const withoutPreloading = {
	name: "without-preloading",
	configResolved({ plugins }) {
		const at = plugins.findIndex(({ name }) => name === "native:import-analysis-build");
		if (at < 0) throw new Error("Vite preloads in another way now; see wasm-core/tools/without_pages.mjs.");
		plugins.splice(at, 1);
	},
};
