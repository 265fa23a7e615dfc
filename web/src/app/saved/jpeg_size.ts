/**
 * Reads width and height from the header of a JPEG (ITU-T T.81, annex B), without decoding; undefined for other data.
 * Skips from segment to segment until a start of frame, which has the size as 16-bit big-endian numbers.
 */
export function jpegSize(bytes: Uint8Array): { width: number; height: number } | undefined {
	if (bytes[0] !== 0xff || bytes[1] !== 0xd8) return undefined;
	for (let at = 2; at + 9 <= bytes.length && bytes[at] === 0xff; ) {
		const marker = bytes[at + 1];
		// A start of frame; three markers of this range are tables of other kinds (DHT, JPG, DAC).
		if (marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker)) {
			return { height: (bytes[at + 5] << 8) | bytes[at + 6], width: (bytes[at + 7] << 8) | bytes[at + 8] };
		}
		at += 2 + ((bytes[at + 2] << 8) | bytes[at + 3]);
	}
	return undefined;
}

/** Greatest size of a picture, bytes; ten times that of a usual one. */
export const LARGEST_PICTURE = 96 * 1024;
/** Greatest width and height of a picture, pixels: a small file may decode to an image that fills the memory. */
export const LONGEST_SIDE = 1024;

/** Returns whether bytes are a JPEG that is safe to decode. */
export function isSmallJpeg(picture: Uint8Array): boolean {
	const size = picture.length <= LARGEST_PICTURE ? jpegSize(picture) : undefined;
	return size !== undefined && Math.max(size.width, size.height) <= LONGEST_SIDE;
}
