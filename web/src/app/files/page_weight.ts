/** What a page has fetched, as a host sends it: each file packed by gzip, whatever this one does. */

export interface PageWeight {
	/** Bytes of pages, styles and scripts. */
	readonly scripts: number;
	/** Bytes of cores. */
	readonly cores: number;
}

/** Packed sizes of files by their addresses, which hold what they hold. */
const known = new Map<string, Promise<number>>();

/**
 * @param addresses of files that were fetched, of any origin
 * @param origin whose are counted
 */
export async function pageWeight(addresses: Iterable<string>, origin: string): Promise<PageWeight> {
	const own = [...new Set(addresses)].filter((address) => address.startsWith(`${origin}/`));
	const sizes = await Promise.all(own.map(async (address) => ({ address, bytes: await packed(address) })));
	const sum = (core: boolean) =>
		sizes.filter(({ address }) => isCore(address) === core).reduce((all, { bytes }) => all + bytes, 0);
	return { scripts: sum(false), cores: sum(true) };
}

const isCore = (address: string) => new URL(address).pathname.endsWith(".wasm");

/** 0 where it cannot be had. */
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
