/** Changes colours that are too similar to others in a list as little as possible. Pure. */
import { clamp, fromLch, type Lch, toLch } from "../../../plant/colour";

/** Least distance of two colours (OKLab), and steps of lightness and of hue (radians) that are tried. */
const APART = 0.07;
const STEP = 0.05;
const TURN = 0.5;
/** Least chroma of a colour whose hue is changed. */
const MIN_CHROMA = 0.1;

type StandRange = readonly [least: number, most: number];

/**
 * Each colour as close to the wanted one as the earlier colours permit; unchanged where no free colour is left.
 * @param range range of lightness for all colours
 */
export function separateColours(wanted: readonly Lch[], range: StandRange): Lch[] {
	const separated: Lch[] = [];
	for (const each of wanted)
		separated.push(apartFrom(separated, { ...each, lightness: clamp(each.lightness, ...range) }, range));
	return separated;
}

/** Varies lightness before hue: kinds are recognized by their hue. */
function apartFrom(others: readonly Lch[], wanted: Lch, [least, most]: StandRange): Lch {
	const free = (lch: Lch) => others.every((other) => distance(lch, other) >= APART);
	for (const turn of eitherWay(TURN, Math.PI))
		for (const more of eitherWay(STEP, most - least)) {
			const lightness = wanted.lightness + more;
			if (lightness < least || lightness > most) continue;
			const chroma = turn === 0 ? wanted.chroma : Math.max(MIN_CHROMA, wanted.chroma);
			const shown = displayable({ lightness, chroma, hue: wanted.hue + turn });
			if (free(shown)) return shown;
		}
	return displayable(wanted);
}

/** Maps a colour to the screen's gamut. */
const displayable = (lch: Lch): Lch => toLch(fromLch(lch));

/** 0, step, -step, 2 step, … up to `far`. */
const eitherWay = (step: number, far: number): number[] =>
	[0].concat(...Array.from({ length: Math.floor(far / step) }, (_, i) => [step * (i + 1), -step * (i + 1)]));

function distance(one: Lch, other: Lch): number {
	const [a, b] = [one, other].map(({ chroma, hue }) => [chroma * Math.cos(hue), chroma * Math.sin(hue)]);
	return Math.hypot(one.lightness - other.lightness, a[0] - b[0], a[1] - b[1]);
}
