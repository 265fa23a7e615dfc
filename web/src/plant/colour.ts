/** Colours as linear light, and conversions to spaces with perceptually even steps. */

/** Linear red, green, blue, 0 … 1. */
export type Colour = [red: number, green: number, blue: number];

/**
 * OKLCh: perceived lightness 0 … 1, chroma 0 … about 0.3, hue in radians (Ottosson 2020, "A perceptual color space").
 */
export interface Lch {
	lightness: number;
	chroma: number;
	hue: number;
}

/** Mid grey, in place of a colour that cannot be read. */
const UNREADABLE = 0x808080;

/**
 * Converts six hexadecimal digits of sRGB, with or without `#`, to linear light (IEC 61966-2-1); mid grey where they
 * cannot be read.
 */
export function linear(hex: string): Colour {
	const digits = /^#?([0-9a-f]{6})$/i.exec(hex)?.[1];
	const value = digits === undefined ? UNREADABLE : Number.parseInt(digits, 16);
	return [decoded((value >> 16) & 255), decoded((value >> 8) & 255), decoded(value & 255)];
}

/** Converts one channel of sRGB, 0 … 255, to linear light. */
function decoded(byte: number): number {
	const channel = byte / 255;
	return channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4;
}

/** Converts linear light to sRGB, both 0 … 1. */
export function encoded(colour: Colour): Colour {
	return colour.map((c) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055)) as Colour;
}

/**
 * Converts linear light (sRGB primaries) to lightness, chroma and hue of OKLab (Ottosson 2020); the constants are its
 * two matrices.
 */
export function toLch([red, green, blue]: Colour): Lch {
	const l = Math.cbrt(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
	const m = Math.cbrt(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
	const s = Math.cbrt(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
	const lightness = 0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s;
	const a = 1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s;
	const b = 0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s;
	return { lightness, chroma: Math.hypot(a, b), hue: Math.atan2(b, a) };
}

/** Converts OKLCh to linear light, each channel brought back into 0 … 1. */
export function fromLch({ lightness, chroma, hue }: Lch): Colour {
	const a = chroma * Math.cos(hue);
	const b = chroma * Math.sin(hue);
	const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
	const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
	const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
	return [
		clamp(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
		clamp(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
		clamp(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
	];
}

/** Clamps the value to the range. */
export function clamp(value: number, low = 0, high = 1): number {
	return Math.min(high, Math.max(low, value));
}

/** Returns 0 up to `low`, 1 from `high` on, and a smooth (Hermite) transition between them. */
export function smoothstep(low: number, high: number, value: number): number {
	const t = clamp((value - low) / (high - low));
	return t * t * (3 - 2 * t);
}

/**
 * Interpolates linearly from one number to another.
 * @param share 0 gives `from`, 1 gives `to`
 */
export function mix(from: number, to: number, share: number): number {
	return from + (to - from) * share;
}

/**
 * Interpolates linearly from one colour to another.
 * @param share 0 gives `from`, 1 gives `to`
 */
export function mixed(from: Colour, to: Colour, share: number): Colour {
	return [mix(from[0], to[0], share), mix(from[1], to[1], share), mix(from[2], to[2], share)];
}

/** Returns the mean of vertex colours, 3 × vertices, at least one. */
export function meanColour(colours: ArrayLike<number>): Colour {
	const sum: Colour = [0, 0, 0];
	for (let i = 0; i < colours.length; i++) sum[i % 3] += colours[i];
	return sum.map((value) => value / (colours.length / 3)) as Colour;
}
