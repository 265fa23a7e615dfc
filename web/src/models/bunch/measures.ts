/** The bunch's measures by their keys, and the class of its skin's colour. */

import { translatedMeasureOf } from "../../specimen/translated_tables";
import { MEASURE_KEYS, type MeasureKey, SKIN_COLOUR } from "./measures.generated";
import type { Look } from "./specimen";

/** The descriptor of skin colour, which is of the look and not measured by the core. */
export const SKIN = translatedMeasureOf("bunch", SKIN_COLOUR);

/** Returns a measure of a bunch by its key; NaN if it does not apply or was not requested. */
export function measureOf(measures: Float32Array | undefined, key: MeasureKey): number {
	return measures?.[MEASURE_KEYS.indexOf(key)] ?? Number.NaN;
}

/**
 * Converts a colour, six hexadecimal digits of sRGB, to CIELAB (D65; IEC 61966-2-1, CIE 15): first to linear light,
 * then to X, Y, Z, then to L*, a*, b*.
 */
export function lab(colour: string): [number, number, number] {
	const [r, g, b] = [0, 2, 4].map((at) => {
		const value = Number.parseInt(colour.slice(at, at + 2), 16) / 255;
		return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
	});
	const f = (t: number) => (t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27) * (t / 116) + 16 / 116);
	const x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
	const y = f(0.2126729 * r + 0.7151522 * g + 0.072175 * b);
	const z = f((0.0193339 * r + 0.119192 * g + 0.9503041 * b) / 1.08883);
	return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

export type SkinClass = (typeof SKIN.classes)[number];

/** Returns the class of skin colour (OIV 225): that of the nearest colour, in CIELAB, to the ripe skin's. */
export function skinClass(look: Pick<Look, "skin">): SkinClass {
	const skin = lab(look.skin);
	const distance = (colour: string) => Math.hypot(...lab(colour).map((value, i) => value - skin[i]));
	const nearest = ({ like }: SkinClass) => Math.min(...like.map(distance));
	return [...SKIN.classes].sort((a, b) => nearest(a) - nearest(b))[0];
}
