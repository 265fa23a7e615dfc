/** Leaves side by side on paper, flat, in the same scale: their margins, and their veins as wide as they are. */
import type { Leaf } from "../../web/src/models/leaf/grown";

interface Subject {
	name: string;
	leaf: Leaf;
	/** Of the leaf from petiole to tip. */
	millimetres: number;
}

const GAP = 8;
/** Widths are in so many classes, each a path of its own. */
const CLASSES = 8;
/** Thinner than this nothing is drawn, in millimetres. */
const HAIR = 0.09;

/** SVG in tenths of a millimetre. */
export function figureOf(subjects: readonly Subject[]): string {
	const boxes = subjects.map(({ leaf, millimetres }) => {
		const xs = leaf.margin.filter((_, at) => at % 2 === 0);
		const ys = leaf.margin.filter((_, at) => at % 2 === 1);
		const [left, right] = [Math.min(...xs), Math.max(...xs)].map((x) => x * millimetres);
		const [low, high] = [Math.min(...ys), Math.max(...ys)].map((y) => y * millimetres);
		return { left, low, high, width: right - left, height: high - low };
	});
	const height = Math.max(...boxes.map((box) => box.height)) + 2 * GAP;
	let x = GAP;
	const leaves = subjects.map((subject, index) => {
		const { left, low, width } = boxes[index];
		const shift = [x - left, height - GAP + low];
		x += width + GAP;
		return leafOf(subject, shift);
	});
	const size = `width="${Math.ceil(x)}mm" height="${Math.ceil(height)}mm" viewBox="0 0 ${Math.ceil(10 * x)} ${Math.ceil(10 * height)}"`;
	return `<svg xmlns="http://www.w3.org/2000/svg" ${size}><title>Four leaves: beech, oak, grapevine and willow</title>\n<rect width="100%" height="100%" fill="#fff"/>\n${leaves.join("\n")}\n</svg>\n`;
}

function leafOf({ name, leaf: { chart, margin, segments }, millimetres }: Subject, [right, down]: number[]): string {
	const at = (values: ArrayLike<number>, k: number) =>
		[
			Math.round(10 * (right + millimetres * values[k])),
			Math.round(10 * (down - millimetres * values[k + 1])),
		] as const;
	const edge: string[] = [];
	for (let k = 0; k < margin.length; k += 2) edge.push(at(margin, k).join(" "));
	const widest = Math.sqrt(Math.max(...segments.radii));
	const classOf = (i: number) =>
		Math.min(Math.floor((CLASSES * Math.sqrt(segments.radii[2 * i + 1])) / widest), CLASSES - 1);
	const last = new Map<number, number>();
	for (let i = 0; i < segments.count; i++) last.set(segments.parent[i], i);
	const paths: string[] = Array.from({ length: CLASSES }, () => "");
	const pens = paths.map(() => [0, 0]);
	const drawn = new Uint8Array(segments.count);
	for (let first = 0; first < segments.count; first++) {
		const wide = classOf(first);
		if (drawn[first]) continue;
		const go = (letter: string, to: readonly number[]) => {
			paths[wide] += `${letter}${to[0] - pens[wide][0]} ${to[1] - pens[wide][1]}`.replaceAll(" -", "-");
			pens[wide] = [...to];
		};
		go("m", at(chart, 4 * first));
		// Continues along a child segment of the same width class.
		for (let i: number | undefined = first; i !== undefined && !drawn[i] && classOf(i) === wide; i = last.get(i)) {
			go("l", at(chart, 4 * i + 2));
			drawn[i] = 1;
		}
	}
	const veins = paths.map((path, index) => {
		const width = Math.max(2000 * (((index + 0.5) / CLASSES) * widest) ** 2, HAIR);
		return path && `<path stroke-width="${(10 * width).toFixed(1)}" d="${path}"/>`;
	});
	return `<g id="${name}" fill="none" stroke="#222" stroke-linecap="round"><path stroke="#5a7a3c" stroke-width="2" d="M${edge.join("L")}Z"/>${veins.join("")}</g>`;
}
