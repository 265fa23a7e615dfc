/** Sums the size of the files that a page has fetched, each compressed by gzip as hosts send them. */

export interface PageWeight {
	/** Bytes of pages, styles and scripts. */
	readonly scripts: number;
	/** Bytes of cores. */
	readonly cores: number;
}

/** Compressed sizes by address; files at an address never change. */
const known = new Map<string, Promise<number>>();

/**
 * Sums the compressed sizes of fetched files, those of cores separately.
 * @param addresses addresses of the fetched files, of any origin
 * @param origin only files of this origin count
 */
export async function pageWeight(addresses: Iterable<string>, origin: string): Promise<PageWeight> {
	const own = [...new Set(addresses)].filter((address) => address.startsWith(`${origin}/`));
	const sizes = await Promise.all(own.map(async (address) => ({ address, bytes: await packed(address) })));
	const sum = (core: boolean) =>
		sizes.filter(({ address }) => isCore(address) === core).reduce((all, { bytes }) => all + bytes, 0);
	return { scripts: sum(false), cores: sum(true) };
}

/** Returns whether an address is that of a core. */
const isCore = (address: string) => new URL(address).pathname.endsWith(".wasm");

/** Returns the compressed size of a file in bytes; 0 if it cannot be fetched. */
function packed(address: string): Promise<number> {
	const before = known.get(address);
	if (before) return before;
	const size = packedSize(address).catch(() => {
		known.delete(address);
		return 0;
	});
	known.set(address, size);
	return size;
}

/** Returns the size of a file in bytes after compression by gzip; the file comes from the browser's cache. */
async function packedSize(address: string): Promise<number> {
	const { body } = await fetch(address, { cache: "force-cache" });
	let bytes = 0;
	const count = new WritableStream<Uint8Array>({
		write: (chunk) => {
			bytes += chunk.length;
		},
	});
	await body?.pipeThrough(new CompressionStream("gzip")).pipeTo(count);
	return bytes;
}
