/** What the JSON document says of a flower besides what it says of any plant: its map, so that anyone can check it. */
import { type Cell, writeCsv } from "../../formats/csv";
import { shortFloat } from "../../formats/numbers";
import { integers, lists, placed, Rows, vectors } from "../../formats/rows";
import type { FlowerPlant } from "./flower_plant";

export interface FlowerRecord {
	/** What each volume is called, and how many sides it has. */
	label: string[];
	order: number[];
	/** The volume that each stands on; −1 of the first. */
	parent: number[];
	/** On which of its faces: O, E, C1 …; null of the first. */
	face: (string | null)[];
	/** Those that are sewn to nothing there. */
	attached: number[];
	/** Of each volume N, T, atx, aty, atz, H, L, W, m. */
	values: Rows<number[]>;
	/** α0 … α3: of each dart the one that it leads to. */
	alpha?: Rows<number[]>;
	/** Of each dart its volume. */
	volume?: Rows<number>;
	/** Of each dart where it stands, metres. */
	position?: Rows<number[]>;
}

const NONE = 0xffffffff;

/** O, E, C1 … */
const faceName = (face: number): string => ["O", "E"][face] ?? `C${face - 1}`;

export function flowerRecord({ volumes, darts }: FlowerPlant): FlowerRecord {
	const { labels, label, order, parent, face, attached, values } = volumes;
	const record: FlowerRecord = {
		label: Array.from(label, (of) => labels[of]),
		order: [...order],
		parent: Array.from(parent, (of) => (of === NONE ? -1 : of)),
		face: Array.from(face, (of, i) => (parent[i] === NONE ? null : faceName(of))),
		attached: [...attached.keys()].filter((i) => attached[i] === 1),
		values: new Rows(label.length, vectors<number[]>(values, 9, 0, 9)),
	};
	if (!darts) return record;
	const { alpha, volume, vertex, positions } = darts;
	return {
		...record,
		alpha: new Rows(alpha.length, lists(alpha)),
		volume: new Rows(volume.length, integers(volume)),
		position: new Rows(vertex.length, placed(vectors<number[]>(positions, 3, 0, 3), vertex)),
	};
}

/** A server sends no more darts: some 50 MB. */
export const MOST_DARTS = 600_000;

/** Why its document with the map is not to be sent; undefined where it may. It may have grown without the map. */
export function tooHeavy({ counts: { darts: count = 0 } }: Pick<FlowerPlant, "counts">): string | undefined {
	if (count <= MOST_DARTS) return undefined;
	const [own, most] = [count, MOST_DARTS].map((each) => each.toLocaleString("en"));
	return `the flower’s map has ${own} darts, and at most ${most} are sent; file-map=0 leaves the map out`;
}

/** A line a volume, in the order in which they were made. */
export function volumesTable({ volumes }: FlowerPlant): string {
	const { labels, label, order, parent, face, attached, line, values } = volumes;
	const header = [
		"volume",
		"parent",
		"face",
		"attached",
		"label",
		"order",
		"line",
		"N",
		"T",
		"atx",
		"aty",
		"atz",
		"H",
		"L",
		"W",
		"m",
	];
	const rows = Array.from(label, (of, i): Cell[] => [
		i,
		parent[i] === NONE ? null : parent[i],
		parent[i] === NONE ? null : faceName(face[i]),
		attached[i],
		labels[of],
		order[i],
		line[i] === 0 ? null : line[i],
		...Array.from(values.subarray(9 * i, 9 * i + 9), shortFloat),
	]);
	return writeCsv([header, ...rows]);
}
