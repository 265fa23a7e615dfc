/**
 * A ZIP archive of a few files, compressed with the browser's own deflate (PKWARE APPNOTE 4.3: local headers, central
 * directory, end record). Enough for an OBJ and its MTL to travel as one download.
 */
export interface ZipEntry {
	/** ASCII, without folders. */
	name: string;
	bytes: Uint8Array<ArrayBuffer>;
}

const LOCAL_HEADER = 0x04034b50;
const CENTRAL_HEADER = 0x02014b50;
const END_RECORD = 0x06054b50;
const VERSION = 20;
const DEFLATE = 8;
/** 1980-01-01, the earliest date the format knows: the same bunch gives the same archive. */
const DATE = 0x0021;

/** The archive's bytes. */
export async function zip(entries: readonly ZipEntry[]): Promise<Blob> {
	const files: BlobPart[] = [];
	const directory: Uint8Array<ArrayBuffer>[] = [];
	let offset = 0;
	for (const { name, bytes } of entries) {
		const packed = await deflate(bytes);
		const about = { name, crc: crc32(bytes), packed: packed.length, size: bytes.length };
		const header = entryHeader(LOCAL_HEADER, about);
		files.push(header, packed);
		directory.push(entryHeader(CENTRAL_HEADER, about, offset));
		offset += header.length + packed.length;
	}
	const length = directory.reduce((sum, each) => sum + each.length, 0);
	return new Blob([...files, ...directory, endRecord(entries.length, length, offset)], { type: "application/zip" });
}

interface About {
	name: string;
	crc: number;
	packed: number;
	size: number;
}

function entryHeader(signature: number, about: About, offset = 0): Uint8Array<ArrayBuffer> {
	const central = signature === CENTRAL_HEADER;
	const words: [number, 2 | 4][] = [
		[signature, 4],
		...(central ? ([[VERSION, 2]] as [number, 2][]) : []),
		[VERSION, 2],
		[0, 2],
		[DEFLATE, 2],
		[0, 2],
		[DATE, 2],
		[about.crc, 4],
		[about.packed, 4],
		[about.size, 4],
		[about.name.length, 2],
		[0, 2],
		...(central
			? ([
					[0, 2],
					[0, 2],
					[0, 2],
					[0, 4],
					[offset, 4],
				] as [number, 2 | 4][])
			: []),
	];
	const head = littleEndian(words);
	const bytes = new Uint8Array(head.length + about.name.length);
	bytes.set(head);
	bytes.set(new TextEncoder().encode(about.name), head.length);
	return bytes;
}

function endRecord(count: number, length: number, offset: number): Uint8Array<ArrayBuffer> {
	return littleEndian([
		[END_RECORD, 4],
		[0, 2],
		[0, 2],
		[count, 2],
		[count, 2],
		[length, 4],
		[offset, 4],
		[0, 2],
	]);
}

function littleEndian(words: readonly [value: number, bytes: 2 | 4][]): Uint8Array<ArrayBuffer> {
	const bytes = new Uint8Array(words.reduce((sum, [, width]) => sum + width, 0));
	const view = new DataView(bytes.buffer);
	let at = 0;
	for (const [value, width] of words) {
		if (width === 2) view.setUint16(at, value, true);
		else view.setUint32(at, value, true);
		at += width;
	}
	return bytes;
}

async function deflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
	const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw"));
	return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** CRC-32 of ISO 3309, as ZIP asks. */
export function crc32(bytes: Uint8Array): number {
	let crc = 0xffffffff;
	for (const byte of bytes) crc = CRC_TABLE[(crc ^ byte) & 0xff] ^ (crc >>> 8);
	return (crc ^ 0xffffffff) >>> 0;
}

const CRC_TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
	let crc = byte;
	for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
	return crc;
});
