/** The cores, embedded in the program: one file is the whole service. */

const files = import.meta.glob<string>("../../../../build/core/*.wasm", { query: "?url&inline", import: "default" });

/**
 * Returns the bytes of an embedded core.
 * @param wasm the name of its file: `bunch.wasm`
 */
export async function coreBytes(wasm: string): Promise<Uint8Array<ArrayBuffer>> {
	const [, load] = Object.entries(files).find(([path]) => path.endsWith(`/${wasm}`)) ?? [];
	if (!load) throw new Error(`There is no core ${wasm}.`);
	const address = await load();
	return Uint8Array.from(Buffer.from(address.slice(address.indexOf(",") + 1), "base64"));
}
