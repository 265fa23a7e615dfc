/** Changes colours that are too similar to others in a list as little as possible. Pure. */
import { clamp, fromLch, type Lch, toLch } from "../../../plant/colour";

/** Least distance of two colours (OKLab), and steps of lightness and of hue (radians) that are tried. */
const LEAST_DISTANCE = 0.07;
const LIGHTNESS_STEP = 0.05;
const HUE_STEP = 0.5;
/** Least chroma of a colour whose hue is changed. */
const MIN_CHROMA = 0.1;

type StandRange = readonly [least: number, most: number];

/**
 * Returns each colour as close to the wanted one as the earlier colours permit; unchanged where no free colour is left.
 * @param range range of lightness for all colours
 */
export function separateColours(wanted: readonly Lch[], range: StandRange): Lch[] {
	const separated: Lch[] = [];
	for (const each of wanted)
		separated.push(separatedFrom(separated, { ...each, lightness: clamp(each.lightness, ...range) }, range));
	return separated;
}

/**
 * Returns the colour nearest to the wanted one that is distinct from the others. Varies lightness before hue: kinds are
 * recognized by their hue.
 */
function separatedFrom(others: readonly Lch[], wanted: Lch, [least, most]: StandRange): Lch {
	const isFree = (lch: Lch) => others.every((other) => colourDistance(lch, other) >= LEAST_DISTANCE);
	for (const hueShift of shiftsUpTo(HUE_STEP, Math.PI))
		for (const lightnessShift of shiftsUpTo(LIGHTNESS_STEP, most - least)) {
			const lightness = wanted.lightness + lightnessShift;
			if (lightness < least || lightness > most) continue;
			const chroma = hueShift === 0 ? wanted.chroma : Math.max(MIN_CHROMA, wanted.chroma);
			const candidate = limitedToScreen({ lightness, chroma, hue: wanted.hue + hueShift });
			if (isFree(candidate)) return candidate;
		}
	return limitedToScreen(wanted);
}

/** Maps a colour to the range that screens can display (sRGB). */
const limitedToScreen = (lch: Lch): Lch => toLch(fromLch(lch));

/** Returns the shifts 0, step, −step, 2 step, … up to `limit`, in the order in which they are tried. */
const shiftsUpTo = (step: number, limit: number): number[] =>
	[0].concat(...Array.from({ length: Math.floor(limit / step) }, (_, i) => [step * (i + 1), -step * (i + 1)]));

/**
 * Returns how different two colours look: their distance in OKLab, from polar coordinates (lightness, chroma, hue).
 */
function colourDistance(one: Lch, other: Lch): number {
	const [a, b] = [one, other].map(({ chroma, hue }) => [chroma * Math.cos(hue), chroma * Math.sin(hue)]);
	return Math.hypot(one.lightness - other.lightness, a[0] - b[0], a[1] - b[1]);
}
