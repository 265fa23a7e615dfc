/**
 * Writes the wood of a tree or a root as SVG: seen from the front, in millimetres at a round scale, each branch as one
 * tapering shape from its fork to its tip. Branches farther from the viewer come first and are paler.
 */
import { GENERATOR } from "../../../formats/generator";
import { escaped, short } from "../svg_text";
import type { TrailPlant } from "../trails";

/** Longest side of the drawing and its margin, millimetres. */
const LONGEST = 250;
const MARGIN = 2;
/** Least radius of a branch and least distance between two points along a branch, millimetres. */
const FINEST = 0.03;
const STEP = 0.12;
/** Shades of grey by depth, and the value of the palest one. */
const SHADES = 12;
const FAR = 0xa0;

/** A point along a branch: millimetres to the right and down, and the branch's radius there. */
type PaperPoint = readonly [x: number, y: number, radius: number];

/**
 * Writes the SVG.
 * @param words the title
 * @param link the address that restores the plant
 */
export function woodSvg(plant: TrailPlant, words: string, link: string): string {
	const { ends } = plant.segments;
	const [left, right] = rangeOf(ends, 0);
	const [low, high] = rangeOf(ends, 1);
	const scale = scaleFor(Math.max(right - left, high - low));
	const toPaper = 1000 / scale;
	const branches = branchesOf(plant);
	const depths = branches.map((branch) => depthOf(branch, ends));
	const [far, near] = rangeOf(depths, 0, 1);
	const shades = Array.from({ length: SHADES }, (): string[] => []);
	branches.forEach((branch, i) => {
		const shade = Math.floor((SHADES * (depths[i] - far)) / (near - far || 1));
		shades[Math.min(SHADES - 1, shade)].push(`<path d="${shapeOf(paperPointsOf(branch, plant, toPaper))}"/>`);
	});
	const box = [left * toPaper, -high * toPaper, (right - left) * toPaper, (high - low) * toPaper];
	const [x, y, width, height] = box.map((value, i) => short(value + (i < 2 ? -MARGIN : 2 * MARGIN)));
	const groups = shades.map((paths, i) => `<g fill="${grey(i)}">${paths.map((path) => `\n${path}`).join("")}\n</g>`);
	return `<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="${width}mm" height="${height}mm" viewBox="${x} ${y} ${width} ${height}">
<title>${escaped(words)}</title>
<desc>${escaped(`1 : ${scale}. ${GENERATOR} ${link}`)}</desc>
${groups.filter((_, i) => shades[i].length > 0).join("\n")}
</svg>
`;
}

/**
 * Returns the branches as lists of segment indices from the target outwards: at each fork the segment with the most
 * energy continues the branch.
 */
export function branchesOf({ segments: { count, parent }, energy }: TrailPlant): number[][] {
	// The segment that continues each segment's branch; −1 at a tip.
	const next = new Int32Array(count).fill(-1);
	for (let i = 0; i < count; i++) {
		const inner = parent[i];
		if (inner >= 0 && (next[inner] < 0 || energy[i] > energy[next[inner]])) next[inner] = i;
	}
	const branches: number[][] = [];
	for (let i = 0; i < count; i++) {
		if (parent[i] >= 0 && next[parent[i]] === i) continue;
		const branch: number[] = [];
		for (let at = i; at >= 0; at = next[at]) branch.push(at);
		branches.push(branch);
	}
	return branches;
}

/**
 * Returns the points of a branch on the paper, from the surface of its parent. Points closer than `STEP` to the last
 * one are left out.
 * @param branch indices of its segments from the base outwards
 * @param toPaper millimetres on the paper per metre
 */
function paperPointsOf(
	branch: readonly number[],
	{ segments: { ends, radii, parent } }: TrailPlant,
	toPaper: number,
): PaperPoint[] {
	const place = (at: number, radius: number): PaperPoint => [
		ends[at] * toPaper,
		-ends[at + 1] * toPaper,
		Math.max(FINEST, radius * toPaper),
	];
	const [first] = branch;
	const parentSegment = parent[first];
	const within = parentSegment < 0 ? 0 : radii[2 * parentSegment + 1] - radii[2 * first];
	const out = (segment: number) =>
		Math.hypot(...[0, 1, 2].map((axis) => ends[6 * segment + 3 + axis] - ends[6 * first + axis])) > within;
	const seen = branch.slice(Math.max(0, branch.findIndex(out)));
	const places = [place(6 * seen[0], radii[2 * seen[0]])];
	seen.forEach((segment, k) => {
		const next = place(6 * segment + 3, radii[2 * segment + 1]);
		const [x, y] = places[places.length - 1];
		if (k === seen.length - 1 || Math.hypot(next[0] - x, next[1] - y) >= STEP) places.push(next);
	});
	if (seen[0] === first && within > 0) places[0] = pointBetween(places[0], places[1], within / lengthOf(first, ends));
	return places;
}

/** Returns the point at a share of the way between two points; a share above 1 gives `to`. */
function pointBetween(from: PaperPoint, to: PaperPoint, share: number): PaperPoint {
	const at = (k: 0 | 1 | 2) => from[k] + Math.min(1, share) * (to[k] - from[k]);
	return [at(0), at(1), at(2)];
}

/**
 * Returns the length of a segment, metres; 1 instead of 0, because it is divided by.
 * @param ends 6 numbers for each segment: start x y z, end x y z
 */
function lengthOf(segment: number, ends: Float32Array): number {
	return Math.hypot(...[0, 1, 2].map((axis) => ends[6 * segment + 3 + axis] - ends[6 * segment + axis])) || 1;
}

/** Returns the outline of a branch as SVG path data: along one side to the tip and back along the other. */
function shapeOf(places: readonly PaperPoint[]): string {
	const sides = places.map(([x, y, radius], k) => {
		const [from, to] = [places[Math.max(0, k - 1)], places[Math.min(places.length - 1, k + 1)]];
		const [along, down] = [to[0] - from[0], to[1] - from[1]];
		const length = Math.hypot(along, down) || 1;
		const [across, up] = length > 1e-6 ? [(-down / length) * radius, (along / length) * radius] : [radius, 0];
		return [`${short(x + across)} ${short(y + up)}`, `${short(x - across)} ${short(y - up)}`];
	});
	return `M${[...sides.map(([one]) => one), ...sides.map(([, other]) => other).reverse()].join("L")}Z`;
}

/**
 * Returns the mean z of a branch, the distance towards the viewer, metres.
 * @param branch indices of its segments
 * @param ends 6 numbers for each segment: start x y z, end x y z
 */
function depthOf(branch: readonly number[], ends: Float32Array): number {
	return branch.reduce((sum, segment) => sum + ends[6 * segment + 2] + ends[6 * segment + 5], 0) / (2 * branch.length);
}

/** Returns the least and the largest of every `stride`-th value from index `first` on; [0, 0] without values. */
function rangeOf(values: ArrayLike<number>, first: number, stride = 3): [number, number] {
	let [least, most] = [Infinity, -Infinity];
	for (let at = first; at < values.length; at += stride) {
		least = Math.min(least, values[at]);
		most = Math.max(most, values[at]);
	}
	return least <= most ? [least, most] : [0, 0];
}

/** Returns the least of the scale denominators 1, 2, 5, 10, 20 … at which a length in metres fits on the paper. */
function scaleFor(metres: number): number {
	for (let power = 1; ; power *= 10) {
		const found = [1, 2, 5].find((digit) => (metres * 1000) / (digit * power) <= LONGEST);
		if (found) return found * power;
	}
}

/** Returns the colour of a depth class as `#rrggbb`: class 0 is the palest, the nearest one black. */
function grey(shade: number): string {
	const value = Math.round(FAR * (1 - shade / (SHADES - 1)));
	return `#${value.toString(16).padStart(2, "0").repeat(3)}`;
}
