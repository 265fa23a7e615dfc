/** Where the built cores lie: one file a model. */
const addresses = import.meta.glob<string>("../../../build/core/*.wasm", {
	query: "?url",
	import: "default",
	eager: true,
});

/** The address of a core's file; undefined where none of that name was built. */
export function coreAddress(file: string): string | undefined {
	return addresses[`../../../build/core/${file}`];
}
