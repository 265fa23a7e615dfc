/**
 * Record of a flower in the JSON document, besides that of every plant: its generalized map, so that anyone can check
 * it.
 */

import { type CsvValue, writeCsv } from "../../formats/csv";
import { shortFloat } from "../../formats/numbers";
import { CsvRows, gathered, integers, lists, vectors } from "../../formats/rows";
import type { Message } from "../../locale/texts";
import type { FlowerPlant } from "./flower_plant";
import { text } from "./messages.generated";

export interface FlowerRecord {
	/** Name of each volume, and its number of sides. */
	label: string[];
	order: number[];
	/** Parent volume; −1 of the first. */
	parent: number[];
	/** Face of the parent: O, E, C1 …; null of the first. */
	face: (string | null)[];
	/** Volumes that are not sewn to that face. */
	attached: number[];
	/** N, T, atx, aty, atz, H, L, W, m of each volume. */
	values: CsvRows<number[]>;
	/** α0 … α3: the dart that each dart is linked to. */
	alpha?: CsvRows<number[]>;
	/** Volume of each dart. */
	volume?: CsvRows<number>;
	/** Position of each dart's vertex, metres. */
	position?: CsvRows<number[]>;
}

const NONE = 0xffffffff;

/** Returns the name of a face: O, E, C1 … */
const faceName = (face: number): string => ["O", "E"][face] ?? `C${face - 1}`;

/** Returns the flower for JSON files: its volumes and, if requested, the darts of its generalized map. */
export function flowerRecord({ volumes, darts }: FlowerPlant): FlowerRecord {
	const { labels, label, order, parent, face, attached, values } = volumes;
	const record: FlowerRecord = {
		label: Array.from(label, (code) => labels[code]),
		order: [...order],
		parent: Array.from(parent, (code) => (code === NONE ? -1 : code)),
		face: Array.from(face, (code, i) => (parent[i] === NONE ? null : faceName(code))),
		attached: [...attached.keys()].filter((i) => attached[i] === 1),
		values: new CsvRows(label.length, vectors<number[]>(values, 9, 0, 9)),
	};
	if (!darts) return record;
	const { alpha, volume, vertex, positions } = darts;
	return {
		...record,
		alpha: new CsvRows(alpha.length, lists(alpha)),
		volume: new CsvRows(volume.length, integers(volume)),
		position: new CsvRows(vertex.length, gathered(vectors<number[]>(positions, 3, 0, 3), vertex)),
	};
}

/** Limit of darts that a server sends, about 50 MB of JSON. */
export const MAX_DARTS = 600_000;

/**
 * Returns why the document with the map is too large to send, or undefined if it is not. The flower may have grown
 * without the map.
 */
export function tooHeavy({ counts: { darts: count = 0 } }: Pick<FlowerPlant, "counts">): Message | undefined {
	if (count <= MAX_DARTS) return undefined;
	return text.message("map_too_large", { count, most: MAX_DARTS });
}

/** Writes volumes as CSV, in order of creation. */
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
	const rows = Array.from(label, (code, i): CsvValue[] => [
		i,
		parent[i] === NONE ? null : parent[i],
		parent[i] === NONE ? null : faceName(face[i]),
		attached[i],
		labels[code],
		order[i],
		line[i] === 0 ? null : line[i],
		// The nine values from N to m, as in the header.
		...Array.from(values.subarray(9 * i, 9 * i + 9), shortFloat),
	]);
	return writeCsv([header, ...rows]);
}
