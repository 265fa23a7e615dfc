/**
 * The addresses of the built modules by their paths: one file a model. The development server replaces this module by
 * one that lists modules that are not built yet, too.
 */
export const coreFiles: Record<string, string> = import.meta.glob<string>("../../../build/core/*.wasm", {
	query: "?url",
	import: "default",
	eager: true,
});
