/**
 * Identifies the chosen volume by its descent, since another volume may have its number once the text has changed.
 * Where numbers, lines and faces change, it remains the second PETAL on the third RING of the STEM.
 */
import type { FlowerPlant, Volumes } from "../flower_plant";

/**
 * Path from the first volume to the chosen one: each volume's name, and its index among those of that name with the
 * same parent.
 */
export type ChosenVolume = readonly { readonly label: string; readonly nth: number }[];

type WithVolumes = Pick<FlowerPlant, "volumes">;

const NONE = 0xffffffff;

/** Returns the path to a volume; undefined if there is no volume of that number. */
export function chosenOf(grown: WithVolumes | undefined, volume: number | undefined): ChosenVolume | undefined {
	if (!grown || volume === undefined || !(volume >= 0 && volume < grown.volumes.order.length)) return undefined;
	const { order, parent, label, labels } = grown.volumes;
	const line: number[] = [];
	for (let at = volume; at !== NONE; at = parent[at]) if (line.push(at) > order.length) return undefined; // It would go round.
	line.reverse();
	// Parts of a split volume may come after their children, so each volume is looked up by its parent, independent
	// of their order.
	const behind = new Map(line.map((at, i) => [parent[at], i]));
	const before = new Uint32Array(line.length);
	for (let at = 0; at < order.length; at++) {
		const next = behind.get(parent[at]);
		if (next !== undefined && at < line[next] && label[at] === label[line[next]]) before[next]++;
	}
	return line.map((at, i) => ({ label: labels[label[at]], nth: before[i] }));
}

/** Returns the number of the volume at a path; undefined if there is none. */
export function stillChosen(grown: WithVolumes | undefined, chosen: ChosenVolume | undefined): number | undefined {
	if (!grown || !chosen) return undefined;
	const { labels, label } = grown.volumes;
	const { first, next } = childrenOf(grown.volumes);
	let last: number | undefined;
	for (const { label: called, nth } of chosen) {
		let at = first[last ?? first.length - 1];
		for (let before = 0; at !== NONE; at = next[at]) if (labels[label[at]] === called && before++ === nth) break;
		if (at === NONE) return undefined;
		last = at;
	}
	return last;
}

/** Returns the first child of each volume, with the first volume at index `count`, and the next sibling of each. */
function childrenOf({ order, parent }: Volumes): { first: Uint32Array; next: Uint32Array } {
	const count = order.length;
	const first = new Uint32Array(count + 1).fill(NONE);
	const next = new Uint32Array(count);
	for (let at = count - 1; at >= 0; at--) {
		const from = Math.min(parent[at], count);
		next[at] = first[from];
		first[from] = at;
	}
	return { first, next };
}
