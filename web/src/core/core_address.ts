/** Where the built cores lie: one file a model. */
const addresses = import.meta.glob<string>("../../../build/core/*.wasm", {
	query: "?url",
	import: "default",
	eager: true,
});

/** The address of a core: of a file that was built, by its name, or what is an address already; else undefined. */
export function coreAddress(file: string): string | undefined {
	return addresses[`../../../build/core/${file}`] ?? (URL.canParse(file) ? file : undefined);
}
