/** Text compressed for a link: UTF-8, raw deflate (RFC 1951), base64 in the alphabet for URLs (RFC 4648 §5). */

/** Compresses a text. A byte-order mark and every line end are preserved. */
export async function compressText(text: string): Promise<string> {
	const packed = await transformed(
		new TextEncoder().encode(text),
		new CompressionStream("deflate-raw"),
		Number.POSITIVE_INFINITY,
	);
	return packed ? toBase64(packed) : "";
}

/**
 * Expands a text that `compressText` made.
 * @param longest bytes of UTF-8 after which expansion stops, so that a few hostile bytes cannot fill the memory
 * @returns undefined where the data is damaged or longer than that
 */
export async function expandText(packed: string, longest: number): Promise<string | undefined> {
	try {
		const bytes = await transformed(fromBase64(packed), new DecompressionStream("deflate-raw"), longest);
		return bytes && new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
	} catch {
		return undefined;
	}
}

/** Compresses or expands bytes; undefined if the result is longer than `longest` bytes. */
async function transformed(
	input: Uint8Array<ArrayBuffer>,
	through: CompressionStream | DecompressionStream,
	longest: number,
): Promise<Uint8Array | undefined> {
	const chunks: Uint8Array[] = [];
	let length = 0;
	const reader = new Blob([input]).stream().pipeThrough(through).getReader();
	for (let next = await reader.read(); !next.done; next = await reader.read()) {
		length += next.value.length;
		if (length > longest) {
			await reader.cancel();
			return undefined;
		}
		chunks.push(next.value);
	}
	const output = new Uint8Array(length);
	let written = 0;
	for (const chunk of chunks) {
		output.set(chunk, written);
		written += chunk.length;
	}
	return output;
}

/** Encodes bytes in the alphabet for URLs, without padding. */
export function toBase64(bytes: Uint8Array): string {
	let binary = "";
	for (const byte of bytes) binary += String.fromCharCode(byte);
	return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** Decodes base64 in the alphabet for URLs; throws where it is damaged. */
export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
	const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
	return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
}
