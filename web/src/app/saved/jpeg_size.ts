/** Width and height in the header of a JPEG (ITU-T T.81, annex B), read without decoding; undefined for other data. */
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
