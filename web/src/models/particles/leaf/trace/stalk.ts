/** The stalk of a leaf's silhouette: the one long thin part, cut off where the blade begins. */
import type { Mask, Pixel } from "./picture";
import { blobsOf, largestBlob, maskOf } from "./silhouette";

export interface Blade {
	blade: Mask;
	/** Where the stalk joins; where there is none, where the blade's middle ends below. */
	base: Pixel;
}

/** Thinner than this is stalk or tooth: twice this in the root of the leaf's area. */
const THIN = 0.025;
/** A stalk is at least so many times as long as it may be thick. */
const LONG = 4;

export function withoutStalk(leaf: Mask): Blade {
	const { width, height, inside } = leaf;
	const area = inside.reduce((sum, value) => sum + value, 0);
	const radius = Math.max(1.5, THIN * Math.sqrt(area));
	const body = largestBlob(opened(leaf, radius));
	const thin: Mask = { width, height, inside: inside.map((value, at) => (body.inside[at] ? 0 : value)) };
	const reached = blobsOf(thin)
		.map((members) => ({ members, length: extent(members, width) }))
		.reduce<{ members: Uint32Array; length: number } | undefined>(
			(best, blob) => (blob.length > (best?.length ?? 0) ? blob : best),
			undefined,
		);
	if (!reached || reached.length < LONG * 2 * radius) return { blade: leaf, base: lowest(leaf) };
	const gone = maskOf(width, height, reached.members).inside;
	const blade = largestBlob({ width, height, inside: inside.map((value, at) => (gone[at] ? 0 : value)) });
	return { blade, base: joint(reached.members, blade) };
}

/** What discs of a radius reach without leaving the mask. */
function opened({ width, height, inside }: Mask, radius: number): Mask {
	const core = reach({ width, height, inside: inside.map((value) => 1 - value) }, radius).inside.map(
		(value) => 1 - value,
	);
	return reach({ width, height, inside: core }, radius);
}

/** All pixels within a radius of the mask: a chamfered distance, 3 to a side and 4 to a corner (Borgefors 1986). */
function reach({ width, height, inside }: Mask, radius: number): Mask {
	const far = 3 * (width + height);
	const away = Int32Array.from(inside, (value) => (value ? 0 : far));
	const relax = (at: number, other: number, cost: number, there: boolean) => {
		if (there && away[other] + cost < away[at]) away[at] = away[other] + cost;
	};
	for (let at = 0; at < away.length; at++) {
		const x = at % width;
		relax(at, at - 1, 3, x > 0);
		relax(at, at - width, 3, at >= width);
		relax(at, at - width - 1, 4, x > 0 && at >= width);
		relax(at, at - width + 1, 4, x < width - 1 && at >= width);
	}
	for (let at = away.length - 1; at >= 0; at--) {
		const x = at % width;
		const below = at + width < away.length;
		relax(at, at + 1, 3, x < width - 1);
		relax(at, at + width, 3, below);
		relax(at, at + width + 1, 4, x < width - 1 && below);
		relax(at, at + width - 1, 4, x > 0 && below);
	}
	return { width, height, inside: Uint8Array.from(away, (value) => (value <= 3 * radius ? 1 : 0)) };
}

/** How far apart the ends of a blob are, about. */
function extent(members: Uint32Array, width: number): number {
	const from = (start: number) =>
		members.reduce((best, at) => (apart(at, start, width) > apart(best, start, width) ? at : best), start);
	const end = from(members[0]);
	return apart(from(end), end, width);
}

function apart(one: number, other: number, width: number): number {
	return Math.hypot((one % width) - (other % width), Math.floor(one / width) - Math.floor(other / width));
}

/** The middle of where a stalk touches the blade. */
function joint(stalk: Uint32Array, { width, inside }: Mask): Pixel {
	const touching = [...stalk].filter((at) => [at - 1, at + 1, at - width, at + width].some((other) => inside[other]));
	const sum = touching.reduce(({ x, y }, at) => ({ x: x + (at % width), y: y + Math.floor(at / width) }), {
		x: 0,
		y: 0,
	});
	return { x: sum.x / touching.length + 0.5, y: sum.y / touching.length + 0.5 };
}

/** The last pixel below the silhouette's middle. */
function lowest({ width, inside }: Mask): Pixel {
	let [x, y, count] = [0, 0, 0];
	inside.forEach((value, at) => {
		if (!value) return;
		x += at % width;
		y += Math.floor(at / width);
		count++;
	});
	const column = Math.round(x / count);
	let row = Math.round(y / count);
	while (inside[(row + 1) * width + column]) row++;
	return { x: column + 0.5, y: row + 1 };
}
