/**
 * The addresses of the built modules by path: one file per model. The development server replaces this module by one
 * that also lists modules which are not built yet.
 */
export const coreFiles: Record<string, string> = import.meta.glob<string>("../../../build/core/*.wasm", {
	query: "?url",
	import: "default",
	eager: true,
});
