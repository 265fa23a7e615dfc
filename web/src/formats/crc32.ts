/** CRC-32 as in ZIP archives and PNG (ISO 3309), which reveals damaged files. */

const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
	let bits = byte;
	for (let k = 0; k < 8; k++) bits = bits & 1 ? (bits >>> 1) ^ 0xedb88320 : bits >>> 1;
	return bits;
});

/** Computes the CRC-32 of bytes, byte by byte with a table of the remainders. */
export function crc32(bytes: Uint8Array): number {
	let sum = 0xffffffff;
	for (const byte of bytes) sum = (sum >>> 8) ^ TABLE[(sum ^ byte) & 0xff];
	return (sum ^ 0xffffffff) >>> 0;
}

/** Returns the CRC-32 as eight hexadecimal digits. */
export const crc32Digits = (bytes: Uint8Array): string => crc32(bytes).toString(16).padStart(8, "0");
