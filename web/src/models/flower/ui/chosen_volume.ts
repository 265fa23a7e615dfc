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
	const path: number[] = [];
	for (let at = volume; at !== NONE; at = parent[at]) if (path.push(at) > order.length) return undefined; // It would go round.
	path.reverse();
	// Parts of a split volume may come after their children, so each volume is looked up by its parent, independent
	// of their order.
	const nextOnPath = new Map(path.map((at, i) => [parent[at], i]));
	const earlierSiblings = new Uint32Array(path.length);
	for (let at = 0; at < order.length; at++) {
		const index = nextOnPath.get(parent[at]);
		if (index !== undefined && at < path[index] && label[at] === label[path[index]]) earlierSiblings[index]++;
	}
	return path.map((at, i) => ({ label: labels[label[at]], nth: earlierSiblings[i] }));
}

/** Returns the number of the volume at a path; undefined if there is none. */
export function stillChosen(grown: WithVolumes | undefined, chosen: ChosenVolume | undefined): number | undefined {
	if (!grown || !chosen) return undefined;
	const { labels, label } = grown.volumes;
	const { first, next } = childrenOf(grown.volumes);
	let last: number | undefined;
	for (const { label: name, nth } of chosen) {
		let child = first[last ?? first.length - 1];
		for (let matches = 0; child !== NONE; child = next[child])
			if (labels[label[child]] === name && matches++ === nth) break;
		if (child === NONE) return undefined;
		last = child;
	}
	return last;
}

/** Returns the first child of each volume, with the first volume at index `count`, and the next sibling of each. */
function childrenOf({ order, parent }: Volumes): { first: Uint32Array; next: Uint32Array } {
	const count = order.length;
	const first = new Uint32Array(count + 1).fill(NONE);
	const next = new Uint32Array(count);
	for (let volume = count - 1; volume >= 0; volume--) {
		const parentOrCount = Math.min(parent[volume], count);
		next[volume] = first[parentOrCount];
		first[parentOrCount] = volume;
	}
	return { first, next };
}
