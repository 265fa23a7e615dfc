/**
 * Writes a leaf as SVG: flat, in millimetres, tip up; the margin as one closed path, veins as one path per class of
 * widths.
 */
import { GENERATOR } from "../../formats/generator";
import { escaped, short } from "../particles/svg_text";
import { flatVeins, type Leaf } from "./grown";
import { bundled } from "./outline/bundles";
import type { LeafSpecimen } from "./specimen";
import { leafInWords } from "./words";

/** Number of width classes; with fewer, steps along a main vein become visible. */
const CLASSES = 24;
/** Margin around the leaf, millimetres. */
const MARGIN = 2;

/**
 * Writes the SVG.
 * @param link the address that restores the leaf
 */
export function leafSvg(leaf: Leaf, specimen: LeafSpecimen, link: string): string {
	const { length: size } = specimen.parameters;
	const { ends, widths, margin } = flatVeins(leaf, size);
	const { left, top, width, height } = boxOf(margin, size);
	const point = (x: number, y: number) => `${short(x * size)} ${short(-y * size)}`;
	const edge = Array.from({ length: margin.length / 2 }, (_, i) => point(margin[2 * i], margin[2 * i + 1]));
	const veins = bundled(widths, CLASSES).map((members) => {
		const mean = members.reduce((sum, index) => sum + widths[index], 0) / members.length;
		const lines = chained(members, leaf.segments.parent).map((chain) => {
			const [first] = chain;
			const places = chain.map((index) => point(ends[4 * index + 2], ends[4 * index + 3]));
			return `M${[point(ends[4 * first], ends[4 * first + 1]), ...places].join("L")}`;
		});
		return `<path stroke-width="${Number((mean * size).toPrecision(3))}" d="${lines.join("")}"/>`;
	});
	return `<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="${width}mm" height="${height}mm" viewBox="${left} ${top} ${width} ${height}">
<title>${escaped(leafInWords(leaf, specimen))}</title>
<desc>${escaped(`${GENERATOR} ${link}`)}</desc>
<path id="margin" fill="none" stroke="#000" stroke-width="0.2" stroke-linejoin="round" d="M${edge.join("L")}Z"/>
<g id="veins" fill="none" stroke="#000" stroke-linecap="round" stroke-linejoin="round">
${veins.join("\n")}
</g>
</svg>
`;
}

/**
 * Joins the segments of a class to chains, each of which continues at the end of the last segment. Parents come first.
 */
function chained(members: readonly number[], parent: Int32Array): number[][] {
	const ending = new Map<number, number[]>();
	const chains: number[][] = [];
	for (const index of members) {
		const chain = ending.get(parent[index]);
		if (chain) ending.delete(parent[index]);
		else chains.push([]);
		const run = chain ?? (chains.at(-1) as number[]);
		run.push(index);
		ending.set(index, run);
	}
	return chains;
}

/**
 * Returns the view box of the SVG, with a border of MARGIN, in millimetres and with y down.
 * @param margin 2 × points, in leaf lengths, y up
 * @param size millimetres of a leaf length
 */
function boxOf(margin: Float32Array, size: number) {
	let [left, right, low, high] = [0, 0, 0, 0];
	for (let at = 0; at < margin.length; at += 2) {
		[left, right] = [Math.min(left, margin[at]), Math.max(right, margin[at])];
		[low, high] = [Math.min(low, margin[at + 1]), Math.max(high, margin[at + 1])];
	}
	return {
		left: short(left * size - MARGIN),
		top: short(-high * size - MARGIN),
		width: short((right - left) * size + 2 * MARGIN),
		height: short((high - low) * size + 2 * MARGIN),
	};
}
