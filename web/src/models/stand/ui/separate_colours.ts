/** Colours separated apart: of those that would be taken for one the later is another, by the least change. Pure. */
import { clamp, fromLch, type Lch, toLch } from "../../../plant/colour";

/** Two closer than this are taken for one (OKLab); then one is made lighter or darker by steps, or else turned in hue, radians, either way. */
const APART = 0.07;
const STEP = 0.05;
const TURN = 0.5;
/** What is turned has a hue to tell it by. */
const MIN_CHROMA = 0.1;

type Range = readonly [least: number, most: number];

/**
 * Each as near to what is wanted as the ones before it let it be; as wanted where there is no room left.
 * @param range of lightness, into which all are brought
 */
export function separateColours(wanted: readonly Lch[], range: Range): Lch[] {
	const separated: Lch[] = [];
	for (const each of wanted)
		separated.push(apartFrom(separated, { ...each, lightness: clamp(each.lightness, ...range) }, range));
	return separated;
}

/** Of lightness before hue: a hue is what a sort is known by. */
function apartFrom(others: readonly Lch[], wanted: Lch, [least, most]: Range): Lch {
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

/** A screen has no yellow as yellow as it can be asked for. */
const displayable = (lch: Lch): Lch => toLch(fromLch(lch));

/** 0, step, -step, 2 step, …, up to that far. */
const eitherWay = (step: number, far: number): number[] =>
	[0].concat(...Array.from({ length: Math.floor(far / step) }, (_, i) => [step * (i + 1), -step * (i + 1)]));

function distance(one: Lch, other: Lch): number {
	const [a, b] = [one, other].map(({ chroma, hue }) => [chroma * Math.cos(hue), chroma * Math.sin(hue)]);
	return Math.hypot(one.lightness - other.lightness, a[0] - b[0], a[1] - b[1]);
}
