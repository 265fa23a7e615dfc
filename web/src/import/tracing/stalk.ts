/** Finds the stalk of a silhouette and cuts it off at the blade: the longest thin part, or else the narrow foot. */
import type { Mask, Pixel } from "./picture";
import { blobsOf, largestBlob, maskOf } from "./silhouette";

/** Size in pixels. */
export interface Stalk {
	length: number;
	width: number;
}

export interface Blade {
	blade: Mask;
	/** Position where the stalk joins the blade; without a stalk, the lowest point below the blade's centroid. */
	base: Pixel;
	stalk?: Stalk;
}

/** Half the largest thickness of a stalk or tooth, as a share of the square root of the area. */
const THIN = 0.025;
/** Least length of a stalk, relative to its largest thickness. */
const LONG = 4;
/**
 * Limits of a foot, relative to the silhouette: largest width, least height, and factor by which the silhouette widens
 * above it within a share of its height. A blade that narrows gradually has no foot.
 */
const [NARROW, HIGH, WIDENS, AT_ONCE] = [0.35, 0.1, 2.5, 0.05];
/**
 * Quantile of the row widths, from the narrowest, that is the width of a widening foot: its very end may be rounded.
 */
const NARROWEST = 0.1;
/** A foot ends where it is wider than this, relative to its width where the widening was found. */
const SHOULDER = 1.5;

/** Cuts the stalk off a silhouette: the longest thin part or, if there is none, the narrow foot. */
export function withoutStalk(whole: Mask): Blade {
	const stalk = thinPart(whole) ?? footOf(whole);
	if (!stalk) return { blade: whole, base: lowest(whole) };
	const { width, height, inside } = whole;
	const { members, length, width: wide } = stalk;
	const gone = maskOf(width, height, members).inside;
	const blade = largestBlob({ width, height, inside: inside.map((value, pixel) => (gone[pixel] ? 0 : value)) });
	return { blade, base: joint(members, blade), stalk: { length, width: wide } };
}

interface Part extends Stalk {
	members: Uint32Array;
}

/**
 * Finds the longest part that is too thin for a disc, in any direction: the remainder of an opening by that disc.
 * @returns undefined if it is too short for a stalk
 */
function thinPart(whole: Mask): Part | undefined {
	const { width, height, inside } = whole;
	const area = inside.reduce((sum, value) => sum + value, 0);
	const radius = Math.max(1.5, THIN * Math.sqrt(area));
	const body = largestBlob(opened(whole, radius));
	const thin: Mask = { width, height, inside: inside.map((value, pixel) => (body.inside[pixel] ? 0 : value)) };
	const longest = blobsOf(thin)
		.map((members) => ({ members, length: extent(members, width) }))
		.map((blob) => ({ ...blob, width: blob.members.length / blob.length }))
		.reduce<Part | undefined>((best, blob) => (blob.length > (best?.length ?? 0) ? blob : best), undefined);
	return longest && longest.length >= LONG * 2 * radius ? longest : undefined;
}

/**
 * Finds the narrow foot of an upright silhouette, up to its shoulder, row by row from the lowest.
 * @returns undefined if the silhouette has no narrow foot that widens suddenly
 */
function footOf({ width, height, inside }: Mask): Part | undefined {
	const rows = Array.from({ length: height }, (_, y) => inside.subarray(y * width, (y + 1) * width));
	const [top, end] = [rows.findIndex((row) => row.includes(1)), rows.findLastIndex((row) => row.includes(1))];
	const tall = end + 1 - top;
	const widest = Math.max(...rows.map((row) => row.lastIndexOf(1) + 1 - Math.max(0, row.indexOf(1))));
	const runs: { from: number; to: number }[] = [];
	// In each row, the stretch of pixels that continues the one below.
	for (let y = end, from = rows[end].indexOf(1), to = from + 1; y >= top; y--) {
		const row = rows[y];
		const first = row.subarray(from, to).indexOf(1);
		if (first < 0) break;
		from += first;
		while (from > 0 && row[from - 1]) from--;
		to = from;
		while (to < width && row[to]) to++;
		runs.push({ from, to });
	}
	const wide = runs.map((run) => run.to - run.from);
	const step = Math.max(1, Math.round(AT_ONCE * tall));
	// The foot ends where the stretch widens suddenly; its shoulder reaches up to the row that is clearly wider.
	const found = wide.findIndex((here, k) => k >= HIGH * tall && wide[k + step] >= WIDENS * here);
	if (found < 0 || wide[found] > NARROW * widest) return undefined;
	const length = wide.findIndex((here, k) => k > found && here > SHOULDER * wide[found]);
	const members = runs
		.slice(0, length)
		.flatMap(({ from, to }, k) => Array.from({ length: to - from }, (_, x) => (end - k) * width + from + x));
	// A low quantile of the widths, which single thin rows do not spoil.
	const [narrow] = wide
		.slice(0, length)
		.sort((a, b) => a - b)
		.slice(Math.floor(NARROWEST * length));
	return { members: Uint32Array.from(members), length, width: narrow };
}

/**
 * Morphological opening by a disc: an erosion followed by a dilation, so that parts thinner than the disc disappear.
 * @param radius of the disc, pixels
 */
function opened({ width, height, inside }: Mask, radius: number): Mask {
	const core = dilated({ width, height, inside: inside.map((value) => 1 - value) }, radius).inside.map(
		(value) => 1 - value,
	);
	return dilated({ width, height, inside: core }, radius);
}

/**
 * Returns all pixels within a radius of the mask, by a chamfer distance with weights 3 and 4 (Borgefors 1986): two
 * passes over the picture, from the top left and from the bottom right.
 * @param radius pixels
 */
function dilated({ width, height, inside }: Mask, radius: number): Mask {
	const far = 3 * (width + height);
	const away = Int32Array.from(inside, (value) => (value ? 0 : far));
	const relax = (pixel: number, other: number, cost: number, there: boolean) => {
		if (there && away[other] + cost < away[pixel]) away[pixel] = away[other] + cost;
	};
	for (let pixel = 0; pixel < away.length; pixel++) {
		const x = pixel % width;
		relax(pixel, pixel - 1, 3, x > 0);
		relax(pixel, pixel - width, 3, pixel >= width);
		relax(pixel, pixel - width - 1, 4, x > 0 && pixel >= width);
		relax(pixel, pixel - width + 1, 4, x < width - 1 && pixel >= width);
	}
	for (let pixel = away.length - 1; pixel >= 0; pixel--) {
		const x = pixel % width;
		const below = pixel + width < away.length;
		relax(pixel, pixel + 1, 3, x < width - 1);
		relax(pixel, pixel + width, 3, below);
		relax(pixel, pixel + width + 1, 4, x < width - 1 && below);
		relax(pixel, pixel + width - 1, 4, x > 0 && below);
	}
	return { width, height, inside: Uint8Array.from(away, (value) => (value <= 3 * radius ? 1 : 0)) };
}

/**
 * Returns the approximate distance between the ends of a blob: from its farthest pixel to the one farthest from that.
 * @param members pixel indices
 * @param width of the picture, pixels
 */
function extent(members: Uint32Array, width: number): number {
	const farthestFrom = (start: number) =>
		members.reduce((best, pixel) => (apart(pixel, start, width) > apart(best, start, width) ? pixel : best), start);
	const end = farthestFrom(members[0]);
	return apart(farthestFrom(end), end, width);
}

/** Returns the distance between two pixels, given by their indices in a picture of a width. */
function apart(one: number, other: number, width: number): number {
	return Math.hypot((one % width) - (other % width), Math.floor(one / width) - Math.floor(other / width));
}

/**
 * Returns the middle of the pixels where a stalk touches the blade.
 * @param stalk pixel indices
 */
function joint(stalk: Uint32Array, { width, inside }: Mask): Pixel {
	const touching = [...stalk].filter((pixel) =>
		[pixel - 1, pixel + 1, pixel - width, pixel + width].some((other) => inside[other]),
	);
	const sum = touching.reduce(({ x, y }, pixel) => ({ x: x + (pixel % width), y: y + Math.floor(pixel / width) }), {
		x: 0,
		y: 0,
	});
	return { x: sum.x / touching.length + 0.5, y: sum.y / touching.length + 0.5 };
}

/** Returns the lowest pixel below the silhouette's centroid. */
function lowest({ width, inside }: Mask): Pixel {
	let [x, y, count] = [0, 0, 0];
	inside.forEach((value, pixel) => {
		if (!value) return;
		x += pixel % width;
		y += Math.floor(pixel / width);
		count++;
	});
	const column = Math.round(x / count);
	let row = Math.round(y / count);
	while (inside[(row + 1) * width + column]) row++;
	return { x: column + 0.5, y: row + 1 };
}
